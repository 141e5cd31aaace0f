package robotran.ecj;

import java.math.BigInteger;

/**
 * Formats floating-point numbers for ECJ's constant strings; the build makes ECJ call these methods.
 *
 * <p>The digits are those of Java up to version 18, which compiled the programs for leJOS: as few as identify the number,
 * but at least two, and often one more than necessary. Whole numbers up to 2^63 have all digits that are known. Newer
 * versions of Java differ in the last digits.
 */
public final class DecimalText {
    private static final int DOUBLE_BITS = 53;
    private static final int FLOAT_BITS = 24;

    /** The highest power of two of whole numbers that get all their digits. */
    private static final int WHOLE_UNTIL = 62;

    /** Powers of ten of the first digit at which numbers are written with an exponent. */
    private static final int SMALL = -3;
    private static final int LARGE = 7;

    /** Numbers of fewer bits fitted an int, or a long. */
    private static final int INT_BITS = 32;
    private static final int LONG_BITS = 64;

    private static final BigInteger FIVE = BigInteger.valueOf(5);

    /** The digits, and the power of ten of the first one. */
    private final StringBuilder digits = new StringBuilder();
    private int power;

    private DecimalText() {}

    public static String of(double number) {
        if (isSpecial(number)) return String.valueOf(number);
        long bits = Double.doubleToLongBits(Math.abs(number));
        int exponent = (int) (bits >>> (DOUBLE_BITS - 1));
        long fraction = bits & ((1L << (DOUBLE_BITS - 1)) - 1);
        return text(number < 0, fraction, exponent, DOUBLE_BITS, 1023);
    }

    public static String of(float number) {
        if (isSpecial(number)) return String.valueOf(number);
        int bits = Float.floatToIntBits(Math.abs(number));
        int exponent = bits >>> (FLOAT_BITS - 1);
        long fraction = bits & ((1 << (FLOAT_BITS - 1)) - 1);
        return text(number < 0, fraction, exponent, FLOAT_BITS, 127);
    }

    private static boolean isSpecial(double number) {
        return number == 0 || number != number || Math.abs(number) == Double.POSITIVE_INFINITY;
    }

    /** The text of a number as its bits have it; a normal number has {@code size} bits with the one that is not stored. */
    private static String text(boolean isNegative, long fraction, int exponent, int size, int bias) {
        int significant = size;
        if (exponent == 0) {
            significant = LONG_BITS - Long.numberOfLeadingZeros(fraction);
            exponent = 1 - (size - significant);
            fraction <<= size - significant;
        } else {
            fraction |= 1L << (size - 1);
        }
        DecimalText text = new DecimalText();
        text.develop(fraction << (DOUBLE_BITS - size), exponent - bias, significant);
        return (isNegative ? "-" : "") + text.written();
    }

    /** Finds the digits of {@code fraction}, which has 53 bits, the first of which is worth 2 to {@code exponent}. */
    private void develop(long fraction, int exponent, int significant) {
        int zeros = Long.numberOfTrailingZeros(fraction);
        int used = DOUBLE_BITS - zeros;
        int behindPoint = Math.max(0, used - exponent - 1);
        if (behindPoint == 0 && exponent <= WHOLE_UNTIL) {
            int unknown = exponent > significant ? exponent - significant - 1 : 0;
            developWhole(exponent < DOUBLE_BITS
                ? fraction >>> (DOUBLE_BITS - 1 - exponent) : fraction << (exponent - DOUBLE_BITS + 1), unknown);
            return;
        }
        power = estimate(fraction, exponent);
        int fives = Math.max(0, -power);
        int fivesBelow = Math.max(0, power);
        int twos = fives + behindPoint + exponent;
        int twosBelow = fivesBelow + behindPoint;
        int twosOfHalf = twos - significant;
        twos -= used - 1;
        int common = Math.min(twos, twosBelow);
        twos -= common;
        twosBelow -= common;
        // The next smaller number is nearer to a power of two.
        twosOfHalf -= common + (used == 1 ? 1 : 0);
        if (twosOfHalf < 0) {
            twos -= twosOfHalf;
            twosBelow -= twosOfHalf;
            twosOfHalf = 0;
        }
        int size = Math.max(used + twos + bitsOfFives(fives), twosBelow + 1 + bitsOfFives(fivesBelow + 1));
        generate(
            BigInteger.valueOf(fraction >>> zeros).multiply(FIVE.pow(fives)).shiftLeft(twos),
            FIVE.pow(fivesBelow).shiftLeft(twosBelow),
            FIVE.pow(fives).shiftLeft(twosOfHalf),
            size
        );
    }

    /** Takes the digits of a whole number, without those that stand for less than 2 to {@code unknown}. */
    private void developWhole(long number, int unknown) {
        int dropped = unknown > 1 ? BigInteger.ONE.shiftLeft(unknown).toString().length() - 1 : 0;
        long unit = 1;
        for (int i = 0; i < dropped; i++) unit *= 10;
        long rest = number % unit;
        number /= unit;
        if (dropped > 0 && rest >= unit >> 1) number++;
        digits.append(number);
        power = digits.length() - 1 + dropped;
        while (digits.length() > 1 && digits.charAt(digits.length() - 1) == '0') digits.setLength(digits.length() - 1);
    }

    /** The power of ten of the first digit, or one more. */
    private static int estimate(long fraction, int exponent) {
        double mantissa = (double) fraction / (1L << (DOUBLE_BITS - 1));
        double logarithm = (mantissa - 1.5) * 0.289529654 + 0.176091259 + exponent * 0.301029995663981;
        return (int) Math.floor(logarithm);
    }

    private static int bitsOfFives(int count) {
        if (count == 0) return 0;
        return count <= 26 ? FIVE.pow(count).bitLength() : count * 3;
    }

    /** Takes digits of number / unit until the rest is less than half, by which the number may be wrong. */
    private void generate(BigInteger number, BigInteger unit, BigInteger half, int size) {
        BigInteger ten = unit.multiply(BigInteger.TEN);
        boolean isLow = false;
        boolean isHigh = false;
        boolean isFirst = true;
        while (isFirst || !isLow && !isHigh) {
            BigInteger[] parts = number.divideAndRemainder(unit);
            number = parts[1].multiply(BigInteger.TEN);
            half = half.multiply(BigInteger.TEN);
            boolean isKnown = isFirst || size >= LONG_BITS || wrapped(half, size) > 0;
            isLow = !isKnown || isLess(number, half, size);
            isHigh = !isKnown || isAbove(number, half, ten, size);
            if (isFirst && parts[0].signum() == 0 && !isHigh) {
                power--;
            } else {
                digits.append(parts[0]);
            }
            // With an exponent, there is always a digit behind the point.
            if (isFirst && (power < SMALL || power > LARGE)) {
                isLow = false;
                isHigh = false;
            }
            isFirst = false;
        }
        int middle = compareTwice(number, ten, size);
        boolean isOdd = (digits.charAt(digits.length() - 1) & 1) != 0;
        if (isHigh && (!isLow || middle > 0 || middle == 0 && isOdd)) roundUp();
    }

    /** A number in the int or long that Java took if {@code size} bits are enough, also where it does not fit. */
    private static long wrapped(BigInteger number, int size) {
        return size < INT_BITS ? number.intValue() : number.longValue();
    }

    private static boolean isLess(BigInteger number, BigInteger half, int size) {
        return size < LONG_BITS ? wrapped(number, size) < wrapped(half, size) : number.compareTo(half) < 0;
    }

    private static boolean isAbove(BigInteger number, BigInteger half, BigInteger ten, int size) {
        BigInteger sum = number.add(half);
        return size < LONG_BITS ? wrapped(sum, size) > wrapped(ten, size) : sum.compareTo(ten) >= 0;
    }

    private static int compareTwice(BigInteger number, BigInteger ten, int size) {
        BigInteger twice = number.shiftLeft(1);
        return size < LONG_BITS ? Long.signum(wrapped(twice.subtract(ten), size)) : twice.compareTo(ten);
    }

    private void roundUp() {
        int place = digits.length() - 1;
        while (place > 0 && digits.charAt(place) == '9') {
            digits.setCharAt(place, '0');
            place--;
        }
        if (digits.charAt(place) == '9') {
            digits.setCharAt(0, '1');
            power++;
        } else {
            digits.setCharAt(place, (char) (digits.charAt(place) + 1));
        }
    }

    private String written() {
        if (power < SMALL || power >= LARGE) {
            String rest = digits.length() == 1 ? "0" : digits.substring(1);
            return digits.charAt(0) + "." + rest + "E" + power;
        }
        if (power < 0) return "0." + "00".substring(0, -power - 1) + digits;
        while (digits.length() < power + 2) digits.append('0');
        return digits.substring(0, power + 1) + "." + digits.substring(power + 1);
    }
}
