package java.lang;

/** A whole number of 16 bits as an object. */
public final class Short extends Number {
    /** The lowest number. */
    public static final short MIN_VALUE = -32768;

    /** The highest number. */
    public static final short MAX_VALUE = 32767;

    /** The number of bits. */
    public static final int SIZE = 16;

    /** The class of the plain values, short.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Short> TYPE = (Class<Short>) short[].class.getComponentType();

    private final short value;

    /** Makes an object of the number. */
    public Short(short value) {
        this.value = value;
    }

    /** Makes an object of the number that the text says. */
    public Short(String text) {
        this(parseShort(text));
    }

    /** Gives an object of the number. */
    public static Short valueOf(short value) {
        return new Short(value);
    }

    /** Gives an object of the number that the text says. */
    public static Short valueOf(String text) {
        return new Short(text);
    }

    /** Gives an object of the number that the text says in a system of so many digits. */
    public static Short valueOf(String text, int radix) {
        return new Short(parseShort(text, radix));
    }

    /** Gives the number that the text says; NumberFormatException if it says none. */
    public static short parseShort(String text) {
        return parseShort(text, 10);
    }

    /** Gives the number that the text says in a system of so many digits. */
    public static short parseShort(String text, int radix) {
        int value = Integer.parseInt(text, radix);
        if (value < MIN_VALUE || value > MAX_VALUE) throw new NumberFormatException("number is too big");
        return (short) value;
    }

    /** Gives the number as text. */
    public static String toString(short value) {
        return String.valueOf(value);
    }

    /** Gives the number as a byte. */
    public byte byteValue() {
        return (byte) value;
    }

    /** Gives the number as a short. */
    public short shortValue() {
        return value;
    }

    /** Gives the number as an int. */
    public int intValue() {
        return (int) value;
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

    /**
     * Gives a number below 0 if the other one is larger, and above 0 if it is smaller.
     *
     * @hidden
     */
    public int compareTo(Short other) {
        return value - other.value;
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Short && ((Short) other).value == value;
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        return value;
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }

    /** Gives the number with its two bytes swapped. */
    public static short reverseBytes(short value) {
        return (short) (value << 8 | value >> 8 & 0xFF);
    }
}
