package java.lang;

/** Logarithms and powers of Euler's number, so exact that any power can be made of them. */
final class Powers {
    // The natural logarithm of 2: 42 bits, so that the product with a power of 2 is exact, and the rest.
    private static final double LOGARITHM_OF_2 = 0.6931471805598903;
    private static final double LOGARITHM_OF_2_REST = 5.497923018708371e-14;
    private static final double ONE_BY_LOGARITHM_OF_2 = 1.4426950408889634;
    private static final double ROOT_OF_2 = 1.4142135623730951;
    private static final double THIRD = 0.3333333333333333;
    private static final double THIRD_REST = 1.850371707708594e-17;
    private static final double TWO_TO_THE_54 = 18014398509481984d;

    private Powers() {
    }

    /** The natural logarithm of a number above 0 that is not infinite. */
    static TwoPartNumber logarithm(double number) {
        long bits = Double.doubleToRawLongBits(number);
        int twos = -1023;
        if (bits < 0x10000000000000L) {
            bits = Double.doubleToRawLongBits(number * TWO_TO_THE_54);
            twos -= 54;
        }
        twos += (int) (bits >> 52);
        double mantissa = Double.longBitsToDouble(bits & 0xFFFFFFFFFFFFFL | 0x3FF0000000000000L);
        if (mantissa > ROOT_OF_2) {
            mantissa /= 2;
            twos++;
        }
        // The logarithm is twice the sum of s, s^3 / 3, s^5 / 5 and so on; the first two terms need all their bits.
        double below = mantissa + 1;
        double belowRest = mantissa - (below - 1);
        double above = mantissa - 1;
        double s = above / below;
        double product = s * below;
        double sRest = (above - product - TwoPartNumber.remainder(s, below, product) - s * belowRest) / below;
        TwoPartNumber square = new TwoPartNumber();
        square.setProduct(s, s, 2 * s * sRest);
        double z = square.high;
        double sum = 1 / 25d;
        for (int divisor = 23; divisor >= 5; divisor -= 2) sum = 1d / divisor + z * sum;
        TwoPartNumber result = new TwoPartNumber();
        result.setProduct(z, THIRD, square.low * THIRD + z * THIRD_REST);
        result.setSum(result.high, z * z * sum, result.low);
        result.setProduct(s, result.high, s * result.low + sRest * result.high);
        result.setSum(s, result.high, result.low + sRest);
        double rest = 2 * result.low + twos * LOGARITHM_OF_2_REST;
        result.setSum(twos * LOGARITHM_OF_2, 2 * result.high, rest);
        result.setSum(result.high, result.low, 0);
        return result;
    }

    /** Euler's number to the power of the sum of both. */
    static double exponential(double power, double rest) {
        if (power > 709.9) return Double.POSITIVE_INFINITY;
        if (power < -745.5) return 0;
        int twos = (int) (power * ONE_BY_LOGARITHM_OF_2 + (power < 0 ? -0.5 : 0.5));
        double upper = power - twos * LOGARITHM_OF_2;
        double lower = rest - twos * LOGARITHM_OF_2_REST;
        double x = upper + lower;
        double low = upper - x + lower;
        double sum = 1 / 87178291200d;
        sum = 1 / 6227020800d + x * sum;
        sum = 1 / 479001600d + x * sum;
        sum = 1 / 39916800d + x * sum;
        sum = 1 / 3628800d + x * sum;
        sum = 1 / 362880d + x * sum;
        sum = 1 / 40320d + x * sum;
        sum = 1 / 5040d + x * sum;
        sum = 1 / 720d + x * sum;
        sum = 1 / 120d + x * sum;
        sum = 1 / 24d + x * sum;
        sum = 1 / 6d + x * sum;
        sum = 1 / 2d + x * sum;
        double more = x * x * sum + low * (1 + x);
        double small = x + more;
        double smallRest = x - small + more;
        double result = 1 + small;
        result += 1 - result + small + smallRest;
        if (twos > -1022 && twos < 1024) return result * powerOf2(twos);
        return twos > 0 ? result * 2 * powerOf2(twos - 1) : result * powerOf2(twos + 54) / TWO_TO_THE_54;
    }

    /** 2 to a power from -1022 to 1023. */
    private static double powerOf2(int power) {
        return Double.longBitsToDouble((long) (power + 1023) << 52);
    }
}
