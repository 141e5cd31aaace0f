package robotran.ecj;

import java.math.BigInteger;

/**
 * Parses floating-point constants exactly, as Java specifies; the build makes ECJ call these methods. Not every
 * platform's own parser is exact.
 */
public final class DecimalReader {
    private static final int DOUBLE_BITS = 53;
    private static final int FLOAT_BITS = 24;
    private static final int LEAST_DOUBLE_EXPONENT = -1074;
    private static final int LEAST_FLOAT_EXPONENT = -149;

    /** From this biased exponent on, every number is infinite, whether float or double. */
    private static final int EXPONENTS = 2046;

    /**
     * No number halfway between two doubles has more digits. Of the digits after these, it only matters whether all are
     * 0.
     */
    private static final int DIGITS = 800;

    /** Beyond this, every number is 0 or infinite. */
    private static final int LARGEST_EXPONENT = 1_000_000;

    private DecimalReader() {}

    /** @param text digits, with an optional point, exponent and type letter, as in Java */
    public static Double doubleOf(String text) {
        long bits = bits(text, DOUBLE_BITS, LEAST_DOUBLE_EXPONENT);
        return Double.longBitsToDouble(Math.min(bits, Double.doubleToLongBits(Double.POSITIVE_INFINITY)));
    }

    public static Float floatOf(String text) {
        long bits = bits(text, FLOAT_BITS, LEAST_FLOAT_EXPONENT);
        return Float.intBitsToFloat((int) Math.min(bits, Float.floatToIntBits(Float.POSITIVE_INFINITY)));
    }

    private static long bits(String text, int precision, int leastExponent) {
        StringBuilder digits = new StringBuilder();
        int exponent = 0;
        boolean behindPoint = false;
        boolean rest = false;
        int place = 0;
        for (; place < text.length() && "eEfFdD".indexOf(text.charAt(place)) < 0; place++) {
            char letter = text.charAt(place);
            if (letter == '.') {
                behindPoint = true;
            } else {
                if (digits.length() == DIGITS) {
                    rest |= letter != '0';
                    exponent++;
                } else if (digits.length() > 0 || letter != '0') {
                    digits.append(letter);
                }
                exponent -= behindPoint ? 1 : 0;
            }
        }
        if (digits.length() == 0) {
            return 0;
        }
        if (rest) {
            digits.append('1');
            exponent--;
        }
        return bits(
            new BigInteger(digits.toString()), exponent + writtenExponent(text, place), digits.length(), precision,
            leastExponent);
    }

    /** The exponent after the letter at {@code place}, 0 if the letter is no E. */
    private static int writtenExponent(String text, int place) {
        if (place == text.length() || Character.toLowerCase(text.charAt(place)) != 'e') {
            return 0;
        }
        boolean negative = place + 1 < text.length() && text.charAt(place + 1) == '-';
        int exponent = 0;
        for (int next = place + 1; next < text.length(); next++) {
            char letter = text.charAt(next);
            if (letter >= '0' && letter <= '9') {
                exponent = Math.min(LARGEST_EXPONENT, 10 * exponent + letter - '0');
            }
        }
        return negative ? -exponent : exponent;
    }

    /**
     * The bits of the floating-point number nearest to {@code number} times ten to the power of {@code exponent}; they
     * may exceed those of infinity.
     */
    private static long bits(BigInteger number, int exponent, int digits, int precision, int leastExponent) {
        if (digits + exponent > DIGITS) {
            return Long.MAX_VALUE;
        }
        if (digits + exponent < -DIGITS) {
            return 0;
        }
        BigInteger dividend = exponent > 0 ? number.multiply(BigInteger.TEN.pow(exponent)) : number;
        BigInteger divisor = exponent < 0 ? BigInteger.TEN.pow(-exponent) : BigInteger.ONE;
        int binaryExponent = Math.max(dividend.bitLength() - divisor.bitLength() - precision, leastExponent);
        if (binaryExponent - leastExponent >= EXPONENTS) {
            return Long.MAX_VALUE;
        }
        BigInteger[] quotient = divided(dividend, divisor, binaryExponent);
        if (quotient[0].bitLength() > precision) {
            binaryExponent++;
            quotient = divided(dividend, divisor, binaryExponent);
        }
        BigInteger scaledDivisor = divisor.shiftLeft(Math.max(binaryExponent, 0));
        int half = quotient[1].shiftLeft(1).compareTo(scaledDivisor);
        boolean up = half > 0 || half == 0 && quotient[0].testBit(0);
        long mantissa = quotient[0].longValue() + (up ? 1 : 0);
        // An overflow or underflow of the mantissa carries over to the exponent.
        long hidden = 1L << precision - 1;
        return ((binaryExponent - leastExponent + 1L) << precision - 1) + mantissa - hidden;
    }

    private static BigInteger[] divided(BigInteger dividend, BigInteger divisor, int binaryExponent) {
        BigInteger scaledDividend = dividend.shiftLeft(Math.max(-binaryExponent, 0));
        return scaledDividend.divideAndRemainder(divisor.shiftLeft(Math.max(binaryExponent, 0)));
    }
}
