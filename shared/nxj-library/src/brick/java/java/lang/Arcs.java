package java.lang;

/** The direction of a point, in radians, from which all inverse functions of angles are made. */
final class Arcs {
    /** The angles whose tangents are 0 to 16 sixteenths. */
    private static final double[] ANGLES = {
        0.0, 0.06241880999595735, 0.12435499454676144, 0.18534794999569476, 0.24497866312686414, 0.3028848683749714,
        0.35877067027057225, 0.4124104415973873, 0.4636476090008061, 0.5123894603107377, 0.5585993153435624,
        0.6022873461349642, 0.6435011087932844, 0.6823165548747481, 0.7188299996216245, 0.7531512809621944,
        0.7853981633974483};

    /** What is missing from these angles. */
    private static final double[] REST_OF_ANGLES = {
        0.0, -1.5490756308295046e-18, -3.1253241424539383e-18, 4.180692268843079e-18, 1.0698755618734451e-17,
        -1.1010827903001369e-17, -2.4623815582638635e-17, -1.587652227770689e-17, 2.2698777452961687e-17,
        -2.5462781472855804e-17, -5.4556305485916264e-18, 2.950430737228402e-17, 1.5834785051444286e-17,
        6.943223671560008e-18, -2.1478388444456983e-17, -2.4256934659182068e-17, 3.061616997868383e-17};

    private static final double QUARTER_REST = 6.123233995736766e-17;

    private Arcs() {
    }

    /**
     * The direction of a point with y of 0 or more, which is not the point 0, 0.
     *
     * @param low a small angle to add.
     */
    static double direction(double y, double x, double low) {
        double width = x < 0 ? -x : x;
        boolean isSteep = y > width;
        double shorter = isSteep ? width : y;
        double longer = isSteep ? y : width;
        double start = isSteep ? Math.PI / 2 : x < 0 ? Math.PI : 0;
        double startRest = isSteep ? QUARTER_REST : x < 0 ? 2 * QUARTER_REST : 0;
        double sign = isSteep == x < 0 ? 1 : -1;
        double quotient = shorter / longer;
        int sixteenths = quotient < 0.1 ? 0 : (int) (16 * quotient + 0.5);
        double missing = 0;
        if (sixteenths == 0) {
            double product = quotient * longer;
            missing = (shorter - product - TwoPartNumber.remainder(quotient, longer, product)) / longer;
        } else {
            // The angle between the point and the one of the table.
            double tangent = sixteenths / 16d;
            double upper = TwoPartNumber.upperBits(longer);
            double above = shorter - tangent * upper - tangent * (longer - upper);
            quotient = above / (longer + tangent * shorter);
        }
        double square = quotient * quotient;
        double sum = 1 / 17d;
        sum = 1 / 15d - square * sum;
        sum = 1 / 13d - square * sum;
        sum = 1 / 11d - square * sum;
        sum = 1 / 9d - square * sum;
        sum = 1 / 7d - square * sum;
        sum = 1 / 5d - square * sum;
        sum = 1 / 3d - square * sum;
        double rest = missing + REST_OF_ANGLES[sixteenths] - quotient * square * sum;
        if (start == 0 && sixteenths == 0) return quotient + (rest + low);
        double main = start + sign * ANGLES[sixteenths];
        double error = start - main + sign * ANGLES[sixteenths];
        double added = sign * quotient;
        double result = main + added;
        return result + (main - result + added + (error + startRest + sign * rest + low));
    }
}
