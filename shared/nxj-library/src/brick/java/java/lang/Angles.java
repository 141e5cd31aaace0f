package java.lang;

/**
 * Sines, cosines and tangents as leJOS NXJ computes them: from a remainder of whole turns, with the Chebyshev
 * approximations for an eighth of a turn that fit to 15 digits. Far from 0 the remainder is less exact than in Java.
 */
final class Angles {
    private static final double HALF_TURN = Math.PI;
    private static final double QUARTER_TURN = Math.PI / 2;
    private static final double EIGHTH_TURN = Math.PI / 4;

    private Angles() {
    }

    static double sine(double angle) {
        double rest = angle % (2 * HALF_TURN);
        boolean isNegative = rest < 0;
        if (isNegative) rest = -rest;
        if (rest > HALF_TURN) {
            isNegative = !isNegative;
            rest -= HALF_TURN;
        }
        if (rest > QUARTER_TURN) rest = HALF_TURN - rest;
        double sine = rest < EIGHTH_TURN ? smallSine(rest) : smallCosine(QUARTER_TURN - rest);
        return isNegative ? -sine : sine;
    }

    static double cosine(double angle) {
        double rest = angle % (2 * HALF_TURN);
        boolean isNegative = false;
        if (rest < 0) rest = -rest;
        if (rest > HALF_TURN) {
            isNegative = true;
            rest -= HALF_TURN;
        }
        if (rest > QUARTER_TURN) {
            isNegative = !isNegative;
            rest = HALF_TURN - rest;
        }
        double cosine = rest < EIGHTH_TURN ? smallCosine(rest) : smallSine(QUARTER_TURN - rest);
        return isNegative ? -cosine : cosine;
    }

    static double tangent(double angle) {
        double rest = angle % HALF_TURN;
        boolean isNegative = rest < 0;
        if (isNegative) rest = -rest;
        if (rest > QUARTER_TURN) {
            isNegative = !isNegative;
            rest = HALF_TURN - rest;
        }
        boolean isSteep = rest > EIGHTH_TURN;
        if (isSteep) rest = QUARTER_TURN - rest;
        double square = rest * rest;
        double above = -2.0783852816388208e-5;
        above = 0.003984273522258578 + above * square;
        above = -0.1551562294271972 + above * square;
        above = (1.1632084063591752 + above * square) * rest;
        double below = 5.798383713759289e-7;
        below = -0.0003627755504463479 + below * square;
        below = 0.02985394096778726 + below * square;
        below = -0.5428923648802556 + below * square;
        below = 1.1632084063591752 + below * square;
        double tangent = isSteep ? below / above : above / below;
        return isNegative ? -tangent : tangent;
    }

    /** The sine of 0 to an eighth of a turn. */
    private static double smallSine(double angle) {
        double square = angle * angle;
        double sum = 1.5883056913369978e-10;
        sum = -2.5050482812758418e-8 + sum * square;
        sum = 2.7557311570774412e-6 + sum * square;
        sum = -0.0001984126982196707 + sum * square;
        sum = 0.008333333333308338 + sum * square;
        sum = -0.16666666666666524 + sum * square;
        return (1 + sum * square) * angle;
    }

    /** The cosine of 0 to an eighth of a turn. */
    private static double smallCosine(double angle) {
        double square = angle * angle;
        double sum = -1.1353383322749354e-11;
        sum = 2.0875582460212687e-9 + sum * square;
        sum = -2.7557313098464816e-7 + sum * square;
        sum = 2.480158728388399e-5 + sum * square;
        sum = -0.0013888888888861101 + sum * square;
        sum = 0.04166666666666645 + sum * square;
        sum = -0.5 + sum * square;
        return 1 + sum * square;
    }
}
