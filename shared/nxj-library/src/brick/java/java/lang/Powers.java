package java.lang;

/** Powers of Euler's number and natural logarithms as leJOS NXJ computes them, to about 15 digits. */
final class Powers {
    private static final double LOGARITHM_OF_2 = 0.6931471805599453;
    private static final double LOGARITHM_OF_ROOT_OF_2 = 0.34657359027997264;
    private static final double ONE_BY_LOGARITHM_OF_2 = 1.4426950408889634;
    private static final double ROOT_OF_2 = 1.4142135623730951;
    private static final double ONE_BY_ROOT_OF_2 = 0.7071067811865476;

    private Powers() {
    }

    static double exponential(double power) {
        if (!(power > -750)) return power < 0 ? 0 : Double.NaN;
        if (power > 710) return Double.POSITIVE_INFINITY;
        int twos = (int) (power * ONE_BY_LOGARITHM_OF_2);
        if (power < 0) twos--;
        double x = power - twos * LOGARITHM_OF_2;
        // The polynomial whose largest relative error from 0 to the logarithm of 2 is the smallest.
        double sum = 3.534728372165613e-8;
        sum = 2.560248541212637e-7 + sum * x;
        sum = 2.7764095757136527e-6 + sum * x;
        sum = 2.4787899938611697e-5 + sum * x;
        sum = 0.00019841863599469418 + sum * x;
        sum = 0.0013888871805082296 + sum * x;
        sum = 0.008333333655294413 + sum * x;
        sum = 0.04166666662838898 + sum * x;
        sum = 0.16666666666933783 + sum * x;
        sum = 0.49999999999990424 + sum * x;
        sum = 1.0000000000000013 + sum * x;
        sum = 1 + sum * x;
        if (twos > 1000 || twos < -1000) {
            int most = twos > 0 ? 1000 : -1000;
            twos -= most;
            sum *= twos > 0 ? 0x1p1000 : 0x1p-1000;
        }
        return sum * Double.longBitsToDouble((long) (twos + 1023) << 52);
    }

    static double logarithm(double number) {
        if (!(number > 0)) return number == 0 ? Double.NEGATIVE_INFINITY : Double.NaN;
        if (number == Double.POSITIVE_INFINITY) return number;
        boolean isSmall = number < Double.MIN_NORMAL;
        long bits = Double.doubleToRawLongBits(isSmall ? number * 0x1p64 : number);
        int roots = (int) (bits >> 52) - (isSmall ? 1023 + 64 : 1023) << 1;
        double x = Double.longBitsToDouble(bits & 0xFFFFFFFFFFFFFL | 0x3FF0000000000000L);
        if (x > ROOT_OF_2) {
            roots++;
            x *= ONE_BY_ROOT_OF_2;
        }
        // The logarithm is twice the sum of s, s^3 / 3, s^5 / 5 and so on.
        double s = (x - 1) / (x + 1);
        double square = s * s;
        double sum = 2 / 19d;
        sum = 2 / 17d + sum * square;
        sum = 2 / 15d + sum * square;
        sum = 2 / 13d + sum * square;
        sum = 2 / 11d + sum * square;
        sum = 2 / 9d + sum * square;
        sum = 2 / 7d + sum * square;
        sum = 2 / 5d + sum * square;
        sum = 2 / 3d + sum * square;
        return roots * LOGARITHM_OF_ROOT_OF_2 + (2 + sum * square) * s;
    }

    static double power(double number, double power) {
        if (power != power) return Double.NaN;
        if (power == 0) return 1;
        if (number > 0 || number != number) return exponential(power * logarithm(number));
        boolean isHuge = power < -0x1p62 || power > 0x1p62;
        long whole = isHuge ? 0 : (long) power;
        boolean isOdd = whole == power && (whole & 1) == 1;
        if (number == 0) {
            double zero = isOdd ? number : 0;
            return power > 0 ? zero : 1 / zero;
        }
        if (!isHuge && whole != power && number != Double.NEGATIVE_INFINITY) return Double.NaN;
        double result = exponential(power * logarithm(-number));
        return isOdd ? -result : result;
    }
}
