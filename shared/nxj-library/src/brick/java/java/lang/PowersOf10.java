package java.lang;

/**
 * Multiplies decimal numbers by powers of 10. It takes the powers 1, 2, 4, 8 and so on that add up to the wanted one, each
 * of them rounded, as leJOS NXJ does. So the last digit of what is read or written may be another than the nearest one.
 */
final class PowersOf10 {
    private static final double[] UP = {1e1, 1e2, 1e4, 1e8, 1e16, 1e32, 1e64, 1e128, 1e256};
    private static final double[] DOWN = {1e-1, 1e-2, 1e-4, 1e-8, 1e-16, 1e-32, 1e-64, 1e-128, 1e-256};
    private static final float[] FLOAT_UP = {1e1f, 1e2f, 1e4f, 1e8f, 1e16f, 1e32f};
    private static final float[] FLOAT_DOWN = {1e-1f, 1e-2f, 1e-4f, 1e-8f, 1e-16f, 1e-32f};

    private PowersOf10() {
    }

    /** Multiplies by 10 to a power from -511 to 511, beginning with the largest of the powers that add up to it. */
    static double largestFirst(double number, int power) {
        double[] factors = power < 0 ? DOWN : UP;
        int rest = power < 0 ? -power : power;
        double product = number;
        for (int bit = rest < 32 ? 4 : 8; bit >= 0; bit--) {
            if ((rest >> bit & 1) != 0) product *= factors[bit];
        }
        return product;
    }

    /** Multiplies by 10 to a power from -511 to 511, beginning with the smallest of the powers that add up to it. */
    static double smallestFirst(double number, int power) {
        double[] factors = power < 0 ? DOWN : UP;
        double product = number;
        int bit = 0;
        for (int rest = power < 0 ? -power : power; rest != 0; rest >>= 1) {
            if ((rest & 1) != 0) product *= factors[bit];
            bit++;
        }
        return product;
    }

    /** Multiplies by 10 to a power from -63 to 63, beginning with the largest of the powers that add up to it. */
    static float largestFirst(float number, int power) {
        float[] factors = power < 0 ? FLOAT_DOWN : FLOAT_UP;
        int rest = power < 0 ? -power : power;
        float product = number;
        for (int bit = 5; bit >= 0; bit--) {
            if ((rest >> bit & 1) != 0) product *= factors[bit];
        }
        return product;
    }

    /** Multiplies by 10 to a power from -63 to 63, beginning with the smallest of the powers that add up to it. */
    static float smallestFirst(float number, int power) {
        float[] factors = power < 0 ? FLOAT_DOWN : FLOAT_UP;
        float product = number;
        int bit = 0;
        for (int rest = power < 0 ? -power : power; rest != 0; rest >>= 1) {
            if ((rest & 1) != 0) product *= factors[bit];
            bit++;
        }
        return product;
    }
}
