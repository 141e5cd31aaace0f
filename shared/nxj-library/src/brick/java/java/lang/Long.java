package java.lang;

/** A whole number of 64 bits as an object. */
public final class Long extends Number implements Comparable<Long> {
    /** The lowest number. */
    public static final long MIN_VALUE = 0x8000000000000000L;

    /** The highest number. */
    public static final long MAX_VALUE = 0x7FFFFFFFFFFFFFFFL;

    /** The number of bits. */
    public static final int SIZE = 64;

    /** The class of the plain values, long.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Long> TYPE = (Class<Long>) long[].class.getComponentType();

    private final long value;

    /** Makes an object of the number. */
    public Long(long value) {
        this.value = value;
    }

    /** Makes an object of the number that the text says. */
    public Long(String text) {
        this(parseLong(text));
    }

    /** Gives an object of the number. */
    public static Long valueOf(long value) {
        return new Long(value);
    }

    /** Gives an object of the number that the text says. */
    public static Long valueOf(String text) {
        return new Long(text);
    }

    /** Gives an object of the number that the text says in a system of so many digits. */
    public static Long valueOf(String text, int radix) {
        return new Long(parseLong(text, radix));
    }

    /** Gives the number that the text says; NumberFormatException if it says none. */
    public static long parseLong(String text) {
        return parseLong(text, 10);
    }

    /** Gives the number that the text says in a system of so many digits. */
    public static long parseLong(String text, int radix) {
        if (text == null) throw new NumberFormatException("string is null");
        if (radix < Character.MIN_RADIX || radix > Character.MAX_RADIX) {
            throw new NumberFormatException("given radix is invalid");
        }
        boolean isNegative = text.length() > 0 && text.charAt(0) == '-';
        return parse(text, isNegative ? 1 : 0, isNegative, radix);
    }

    /**
     * Gives the number that the text says, in hexadecimal digits behind # or 0x, in octal ones behind 0.
     *
     * <p>On a brick, it has a minus before it, whether the text has one or not.
     */
    public static Long decode(String text) {
        int length = text.length();
        int place = length > 0 && text.charAt(0) == '-' ? 1 : 0;
        int radix = 10;
        if (place < length && text.charAt(place) == '#') {
            radix = 16;
            place++;
        } else if (place < length && text.charAt(place) == '0') {
            boolean isHexadecimal = place + 1 < length && (text.charAt(place + 1) | 0x20) == 'x';
            radix = isHexadecimal ? 16 : 8;
            place += isHexadecimal ? 2 : 1;
        }
        return new Long(parse(text, place, true, radix));
    }

    /** Gives null: a brick has no properties. */
    public static Long getLong(String name) {
        return getLong(name, null);
    }

    /** Gives the number: a brick has no properties. */
    public static Long getLong(String name, int otherwise) {
        return getLong(name, new Long(otherwise));
    }

    /** Gives the number: a brick has no properties. */
    public static Long getLong(String name, Long otherwise) {
        String text = System.getProperty(name);
        return text == null || text.length() == 0 ? otherwise : decode(text);
    }

    /** Gives the number as text in a system of so many digits. */
    public static String toString(long value, int radix) {
        int base = radix < Character.MIN_RADIX || radix > Character.MAX_RADIX ? 10 : radix;
        char[] characters = new char[SIZE + 1];
        int place = characters.length;
        long rest = value < 0 ? value : -value;
        do {
            characters[--place] = Character.forDigit((int) -(rest % base), base);
            rest /= base;
        } while (rest != 0);
        if (value < 0) characters[--place] = '-';
        return new String(characters, place, characters.length - place);
    }

    /** Gives the bits of the number as text, in hexadecimal digits. */
    public static String toHexString(long value) {
        return digitsOf(value, 4);
    }

    /** Gives the bits of the number as text, in octal digits. */
    public static String toOctalString(long value) {
        return digitsOf(value, 3);
    }

    /** Gives the bits of the number as text. */
    public static String toBinaryString(long value) {
        return digitsOf(value, 1);
    }

    /** Gives the number as text. */
    public static String toString(long value) {
        return toString(value, 10);
    }

    /** Gives the number as a byte. */
    public byte byteValue() {
        return (byte) value;
    }

    /** Gives the number as a short. */
    public short shortValue() {
        return (short) value;
    }

    /** Gives the number as an int. */
    public int intValue() {
        return (int) value;
    }

    /** Gives the number as a long. */
    public long longValue() {
        return value;
    }

    /** Gives the number as a float. */
    public float floatValue() {
        return (float) value;
    }

    /** Gives the number as a double. */
    public double doubleValue() {
        return (double) value;
    }

    /** Gives a number below 0 if the other one is larger, and above 0 if it is smaller. */
    public int compareTo(Long other) {
        return value < other.value ? -1 : value > other.value ? 1 : 0;
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Long && ((Long) other).value == value;
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        return (int) (value ^ value >>> 32);
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }

    /** Gives the number of bits that are 1. */
    public static int bitCount(long value) {
        int count = 0;
        for (long rest = value; rest != 0; rest &= rest - 1) count++;
        return count;
    }

    /** Gives only the highest bit that is 1. */
    public static long highestOneBit(long value) {
        return value == 0 ? 0 : 1L << 64 - 1 - numberOfLeadingZeros(value);
    }

    /** Gives only the lowest bit that is 1. */
    public static long lowestOneBit(long value) {
        return value & -value;
    }

    /** Gives the number of bits above the highest one that is 1. */
    public static int numberOfLeadingZeros(long value) {
        if (value == 0) return 64;
        int zeros = 0;
        long rest = value;
        for (int step = 32; step > 0; step >>= 1) {
            if (rest >>> 64 - step == 0) {
                zeros += step;
                rest <<= step;
            }
        }
        return zeros;
    }

    /** Gives the number of bits below the lowest one that is 1. */
    public static int numberOfTrailingZeros(long value) {
        return value == 0 ? 64 : 64 - 1 - numberOfLeadingZeros(value & -value);
    }

    /** Gives the bits moved to the left; those that fall out come in on the right. */
    public static long rotateLeft(long value, int distance) {
        return value << distance | value >>> -distance;
    }

    /** Gives the bits moved to the right; those that fall out come in on the left. */
    public static long rotateRight(long value, int distance) {
        return value >>> distance | value << -distance;
    }

    /** Gives the bits in the opposite order. */
    public static long reverse(long value) {
        long result = 0;
        long rest = value;
        for (int bit = 0; bit < SIZE; bit++) {
            result = result << 1 | rest & 1;
            rest >>>= 1;
        }
        return result;
    }

    /** Gives the bytes in the opposite order. */
    public static long reverseBytes(long value) {
        long result = 0;
        long rest = value;
        for (int bit = 0; bit < SIZE; bit += 8) {
            result = result << 8 | rest & 0xFF;
            rest >>>= 8;
        }
        return result;
    }

    /** Gives -1 for a number below 0, 1 for one above 0, and 0 for 0. */
    public static int signnum(long value) {
        return (int) (value >> 63) | (int) (-value >>> 63);
    }

    /**
     * Gives -1 for a number below 0, 1 for one above 0, and 0 for 0.
     *
     * @hidden
     */
    public static int signum(long value) {
        return value < 0 ? -1 : value > 0 ? 1 : 0;
    }

    private static long parse(String text, int start, boolean isNegative, int radix) {
        int length = text.length();
        if (start >= length) throw new NumberFormatException("string doesn't contain any digits");
        // Below 0 there is one number more than above it, so that is where the number grows.
        long limit = isNegative ? MIN_VALUE : -MAX_VALUE;
        long last = limit / radix;
        long value = 0;
        for (int place = start; place < length; place++) {
            int digit = Character.digit(text.charAt(place), radix);
            if (digit < 0) throw new NumberFormatException("illegal digit character");
            if (value < last || value * radix < limit + digit) throw new NumberFormatException("number is too big");
            value = value * radix - digit;
        }
        return isNegative ? value : -value;
    }

    private static String digitsOf(long value, int bits) {
        char[] characters = new char[SIZE];
        int place = characters.length;
        long rest = value;
        do {
            characters[--place] = Character.forDigit((int) rest & (1 << bits) - 1, 16);
            rest >>>= bits;
        } while (rest != 0);
        return new String(characters, place, characters.length - place);
    }
}
