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

    /** Exact, and not a number where Java says so, unlike the remainder of WebAssembly's platform. */
    public static double remainder(double dividend, double divisor) {
        if (Double.isNaN(dividend) || Double.isNaN(divisor) || Double.isInfinite(dividend) || divisor == 0) {
            return Double.NaN;
        }
        if (dividend == 0 || Double.isInfinite(divisor)) {
            return dividend;
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
