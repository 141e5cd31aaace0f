package java.lang;

/** Angles of given sines, cosines and tangents as leJOS NXJ computes them: all of them from the angle of a tangent. */
final class Arcs {
    private static final double QUARTER_TURN = Math.PI / 2;
    private static final double EIGHTH_TURN = Math.PI / 4;

    /** The sine of an eighth of a turn. */
    private static final double SINE_OF_EIGHTH = 0.7071067811865476;

    private Arcs() {
    }

    static double ofTangent(double tangent) {
        boolean isNegative = tangent < 0;
        double size = isNegative ? -tangent : tangent;
        boolean isSteep = size > 1;
        double angle = ofSmallTangent(isSteep ? 1 / size : size);
        if (isSteep) angle = QUARTER_TURN - angle;
        return isNegative ? -angle : angle;
    }

    /** The direction of a point; 0 for the point 0, 0, and a minus in front of 0 does not count. */
    static double ofPoint(double up, double right) {
        boolean isDown = up < 0;
        boolean isLeft = right < 0;
        double height = isDown ? -up : up;
        double width = isLeft ? -right : right;
        boolean isSteep = height > width;
        double angle;
        if (height == width) {
            angle = height == 0 ? 0 : EIGHTH_TURN;
        } else {
            angle = ofSmallTangent(isSteep ? width / height : height / width);
        }
        if (isSteep) {
            angle = isLeft ? angle + QUARTER_TURN : QUARTER_TURN - angle;
        } else if (isLeft) {
            angle = Math.PI - angle;
        }
        return isDown ? -angle : angle;
    }

    static double ofSine(double sine) {
        boolean isNegative = sine < 0;
        double size = isNegative ? -sine : sine;
        if (!(size <= 1)) return Double.NaN;
        double other = Math.sqrt(1 - size * size);
        double angle = size < SINE_OF_EIGHTH ? ofSmallTangent(size / other) : QUARTER_TURN - ofSmallTangent(other / size);
        return isNegative ? -angle : angle;
    }

    static double ofCosine(double cosine) {
        boolean isNegative = cosine < 0;
        double size = isNegative ? -cosine : cosine;
        if (!(size <= 1)) return Double.NaN;
        double other = Math.sqrt(1 - size * size);
        if (size < SINE_OF_EIGHTH) {
            double angle = ofSmallTangent(size / other);
            return isNegative ? angle + QUARTER_TURN : QUARTER_TURN - angle;
        }
        double angle = ofSmallTangent(other / size);
        return isNegative ? Math.PI - angle : angle;
    }

    /** The angle of a tangent from 0 to 1: a Chebyshev-Padé approximation that fits to 15 digits. */
    private static double ofSmallTangent(double tangent) {
        double square = tangent * tangent;
        double above = 0.00012030822093367211;
        above = 0.005241080670594091 + above * square;
        above = 0.05998846249230414 + above * square;
        above = 0.2762961405471209 + above * square;
        above = 0.5896935461740918 + above * square;
        above = 0.5822336291803317 + above * square;
        above = (0.21480982386448075 + above * square) * tangent;
        double below = 4.538215780227675e-6;
        below = 0.0006791021403500245 + below * square;
        below = 0.01523641193862142 + below * square;
        below = 0.12029329400162579 + below * square;
        below = 0.4311082828151354 + below * square;
        below = 0.7646772160018243 + below * square;
        below = 0.6538369038018249 + below * square;
        below = 0.21480982386448075 + below * square;
        return above / below;
    }
}
