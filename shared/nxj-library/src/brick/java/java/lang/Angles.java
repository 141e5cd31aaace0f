package java.lang;

/** Takes quarters of a turn from angles in radians, so that -45 to 45 degrees are left, and knows their sines. */
final class Angles {
    // A quarter of a turn, in pieces of 33 bits, so that their products with a number of quarters are exact.
    private static final double QUARTER_1 = 1.5707963267341256;
    private static final double QUARTER_2 = 6.077100506303966e-11;
    private static final double QUARTER_3 = 2.0222662487111665e-21;
    private static final double QUARTER_4 = 8.4784276603689e-32;
    private static final double QUARTERS_PER_RADIAN = 0.6366197723675814;

    /** From here on the pieces are not enough. */
    private static final double LARGE = 1048576;

    private Angles() {
    }

    static TwoPartNumber reduce(double angle) {
        TwoPartNumber rest = new TwoPartNumber();
        if (angle >= LARGE || angle <= -LARGE) {
            LargeAngles.reduce(angle, rest);
            return rest;
        }
        int quarters = (int) (angle * QUARTERS_PER_RADIAN + (angle < 0 ? -0.5 : 0.5));
        rest.quarters = quarters;
        if (quarters == 0) {
            rest.high = angle;
            return rest;
        }
        rest.setSum(angle - quarters * QUARTER_1, -quarters * QUARTER_2, 0);
        rest.setSum(rest.high, -quarters * QUARTER_3, rest.low);
        rest.setSum(rest.high, rest.low - quarters * QUARTER_4, 0);
        return rest;
    }

    /** What the sine of a small angle has more than the angle. */
    static double sineLessAngle(double angle, double low) {
        double square = angle * angle;
        double sum = 1 / 355687428096000d;
        sum = -1 / 1307674368000d + square * sum;
        sum = 1 / 6227020800d + square * sum;
        sum = -1 / 39916800d + square * sum;
        sum = 1 / 362880d + square * sum;
        sum = -1 / 5040d + square * sum;
        sum = 1 / 120d + square * sum;
        sum = -1 / 6d + square * sum;
        return angle * square * sum + low * (1 - square / 2);
    }

    /** The cosine of a small angle. */
    static void setCosine(double angle, double low, TwoPartNumber cosine) {
        double square = angle * angle;
        double sum = 1 / 20922789888000d;
        sum = -1 / 87178291200d + square * sum;
        sum = 1 / 479001600d + square * sum;
        sum = -1 / 3628800d + square * sum;
        sum = 1 / 40320d + square * sum;
        sum = -1 / 720d + square * sum;
        sum = 1 / 24d + square * sum;
        double rest = square * square * sum - angle * low - TwoPartNumber.remainder(angle, angle, square) / 2;
        cosine.setSum(1, -square / 2, rest);
    }
}
