package robotran.physics;

import org.apache.commons.math3.util.FastMath;

/**
 * The only trigonometry for everything that affects a pose. {@link Math} may differ in the last bit between platforms;
 * this is plain arithmetic and does not. Angles are in radians.
 */
public final class Trigonometry {
    private Trigonometry() {}

    public static double sine(double angle) {
        return FastMath.sin(angle);
    }

    public static double cosine(double angle) {
        return FastMath.cos(angle);
    }

    /** The angle of the vector, in (-pi, pi]. */
    public static double angle(double x, double y) {
        double angle = FastMath.atan2(y, x);
        return angle == -Math.PI ? Math.PI : angle;
    }
}
