package robotran.ecj;

import java.math.BigDecimal;

/**
 * Java's division for ECJ's constants; the build makes ECJ call these methods. In WebAssembly, dividing by 0 or the min
 * value by -1 throws no exception but terminates the whole module, and a pupil may write either.
 */
public final class Division {
    private Division() {}

    public static int quotient(int dividend, int divisor) {
        check(divisor == 0);
        return divisor == -1 ? -dividend : dividend / divisor;
    }

    public static long quotient(long dividend, long divisor) {
        check(divisor == 0);
        return divisor == -1 ? -dividend : dividend / divisor;
    }

    public static int remainder(int dividend, int divisor) {
        check(divisor == 0);
        return divisor == -1 ? 0 : dividend % divisor;
    }

    public static long remainder(long dividend, long divisor) {
        check(divisor == 0);
        return divisor == -1 ? 0 : dividend % divisor;
    }

    /** Exact, unlike some platforms' own remainder. */
    public static double remainder(double dividend, double divisor) {
        boolean isPlain = !Double.isNaN(dividend) && !Double.isInfinite(dividend)
            && !Double.isInfinite(divisor) && dividend != 0;
        if (!isPlain || divisor == 0 || Double.isNaN(divisor)) {
            return dividend % divisor;
        }
        double rest = new BigDecimal(dividend).remainder(new BigDecimal(divisor)).doubleValue();
        return rest == 0 ? 0 * dividend : rest;
    }

    public static float remainder(float dividend, float divisor) {
        return (float) remainder((double) dividend, (double) divisor);
    }

    private static void check(boolean byZero) {
        if (byZero) {
            throw new ArithmeticException();
        }
    }
}
