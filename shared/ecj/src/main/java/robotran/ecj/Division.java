package robotran.ecj;

/**
 * Divisions as Java defines them, for ECJ's constants: the build makes ECJ call these. WebAssembly does not throw an exception for a
 * division by 0, nor divide the least number by -1, but ends the whole module, and a pupil may write either.
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

    private static void check(boolean byZero) {
        if (byZero) {
            throw new ArithmeticException();
        }
    }
}
