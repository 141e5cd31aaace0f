package java.lang;

/** A whole number of 32 bits as an object. */
public final class Integer extends Number implements Comparable<Integer> {
    /** The lowest number. */
    public static final int MIN_VALUE = 0x80000000;

    /** The highest number. */
    public static final int MAX_VALUE = 0x7FFFFFFF;

    /** The number of bits. */
    public static final int SIZE = 32;

    /** The lowest system of digits; better take that of Character. */
    @Deprecated
    public static final int MIN_RADIX = Character.MIN_RADIX;

    /** The highest system of digits; better take that of Character. */
    @Deprecated
    public static final int MAX_RADIX = Character.MAX_RADIX;

    /** The class of the plain values, int.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Integer> TYPE = (Class<Integer>) int[].class.getComponentType();

    private final int value;

    /** Makes an object of the number. */
    public Integer(int value) {
        this.value = value;
    }

    /** Makes an object of the number that the text says. */
    public Integer(String text) {
        this(parseInt(text));
    }

    /** Gives an object of the number. */
    public static Integer valueOf(int value) {
        return new Integer(value);
    }

    /** Gives an object of the number that the text says. */
    public static Integer valueOf(String text) {
        return new Integer(text);
    }

    /** Gives an object of the number that the text says in a system of so many digits. */
    public static Integer valueOf(String text, int radix) {
        return new Integer(parseInt(text, radix));
    }

    /** Gives the number that the text says; NumberFormatException if it says none. */
    public static int parseInt(String text) {
        return parseInt(text, 10);
    }

    /** Gives the number that the text says in a system of so many digits. */
    public static int parseInt(String text, int radix) {
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
    public static Integer decode(String text) {
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
        return new Integer(parse(text, place, true, radix));
    }

    /** Gives null: a brick has no properties. */
    public static Integer getInteger(String name) {
        return getInteger(name, null);
    }

    /** Gives the number: a brick has no properties. */
    public static Integer getInteger(String name, int otherwise) {
        return getInteger(name, new Integer(otherwise));
    }

    /** Gives the number: a brick has no properties. */
    public static Integer getInteger(String name, Integer otherwise) {
        String text = System.getProperty(name);
        return text == null || text.length() == 0 ? otherwise : decode(text);
    }

    /** Gives the number as text in a system of so many digits. */
    public static String toString(int value, int radix) {
        int base = radix < Character.MIN_RADIX || radix > Character.MAX_RADIX ? 10 : radix;
        char[] characters = new char[SIZE + 1];
        int place = characters.length;
        int rest = value < 0 ? value : -value;
        do {
            characters[--place] = Character.forDigit((int) -(rest % base), base);
            rest /= base;
        } while (rest != 0);
        if (value < 0) characters[--place] = '-';
        return new String(characters, place, characters.length - place);
    }

    /** Gives the bits of the number as text, in hexadecimal digits. */
    public static String toHexString(int value) {
        return digitsOf(value, 4);
    }

    /** Gives the bits of the number as text, in octal digits. */
    public static String toOctalString(int value) {
        return digitsOf(value, 3);
    }

    /** Gives the bits of the number as text. */
    public static String toBinaryString(int value) {
        return digitsOf(value, 1);
    }

    /** Gives the number as text. */
    public static String toString(int value) {
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
        return value;
    }

    /** Gives the number as a long. */
    public long longValue() {
        return (long) value;
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
    public int compareTo(Integer other) {
        return value < other.value ? -1 : value > other.value ? 1 : 0;
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Integer && ((Integer) other).value == value;
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        return value;
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }

    /** Gives the number of bits that are 1. */
    public static int bitCount(int value) {
        int count = 0;
        for (int rest = value; rest != 0; rest &= rest - 1) count++;
        return count;
    }

    /** Gives only the highest bit that is 1. */
    public static int highestOneBit(int value) {
        return value == 0 ? 0 : 1 << 32 - 1 - numberOfLeadingZeros(value);
    }

    /** Gives only the lowest bit that is 1. */
    public static int lowestOneBit(int value) {
        return value & -value;
    }

    /** Gives the number of bits above the highest one that is 1. */
    public static int numberOfLeadingZeros(int value) {
        if (value == 0) return 32;
        int zeros = 0;
        int rest = value;
        for (int step = 16; step > 0; step >>= 1) {
            if (rest >>> 32 - step == 0) {
                zeros += step;
                rest <<= step;
            }
        }
        return zeros;
    }

    /** Gives the number of bits below the lowest one that is 1. */
    public static int numberOfTrailingZeros(int value) {
        return value == 0 ? 32 : 32 - 1 - numberOfLeadingZeros(value & -value);
    }

    /** Gives the bits moved to the left; those that fall out come in on the right. */
    public static int rotateLeft(int value, int distance) {
        return value << distance | value >>> -distance;
    }

    /** Gives the bits moved to the right; those that fall out come in on the left. */
    public static int rotateRight(int value, int distance) {
        return value >>> distance | value << -distance;
    }

    /** Gives the bits in the opposite order. */
    public static int reverse(int value) {
        int result = 0;
        int rest = value;
        for (int bit = 0; bit < SIZE; bit++) {
            result = result << 1 | rest & 1;
            rest >>>= 1;
        }
        return result;
    }

    /** Gives the bytes in the opposite order. */
    public static int reverseBytes(int value) {
        int result = 0;
        int rest = value;
        for (int bit = 0; bit < SIZE; bit += 8) {
            result = result << 8 | rest & 0xFF;
            rest >>>= 8;
        }
        return result;
    }

    /** Gives -1 for a number below 0, 1 for one above 0, and 0 for 0; only for numbers of 32 bits. */
    public static int signnum(long value) {
        return (int) (value >> 31) | (int) (-value >>> 31);
    }

    /** Gives the number of a digit, or -1; better take that of Character. */
    @Deprecated
    public static int digit(char digit, int radix) {
        return Character.digit(digit, radix);
    }

    /** Gives the number of a digit, or -1; better take that of Character. */
    @Deprecated
    public static int digit(int digit, int radix) {
        return Character.digit(digit, radix);
    }

    /**
     * Gives -1 for a number below 0, 1 for one above 0, and 0 for 0.
     *
     * @hidden
     */
    public static int signum(int value) {
        return value < 0 ? -1 : value > 0 ? 1 : 0;
    }

    private static int parse(String text, int start, boolean isNegative, int radix) {
        int length = text.length();
        if (start >= length) throw new NumberFormatException("string doesn't contain any digits");
        // Below 0 there is one number more than above it, so that is where the number grows.
        int limit = isNegative ? MIN_VALUE : -MAX_VALUE;
        int last = limit / radix;
        int value = 0;
        for (int place = start; place < length; place++) {
            int digit = Character.digit(text.charAt(place), radix);
            if (digit < 0) throw new NumberFormatException("illegal digit character");
            if (value < last || value * radix < limit + digit) throw new NumberFormatException("number is too big");
            value = value * radix - digit;
        }
        return isNegative ? value : -value;
    }

    private static String digitsOf(int value, int bits) {
        char[] characters = new char[SIZE];
        int place = characters.length;
        int rest = value;
        do {
            characters[--place] = Character.forDigit((int) rest & (1 << bits) - 1, 16);
            rest >>>= bits;
        } while (rest != 0);
        return new String(characters, place, characters.length - place);
    }
}
