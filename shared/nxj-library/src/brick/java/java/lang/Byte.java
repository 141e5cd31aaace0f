package java.lang;

/** A whole number from -128 to 127 as an object. */
public final class Byte extends Number {
    /** The lowest number. */
    public static final byte MIN_VALUE = -128;

    /** The highest number. */
    public static final byte MAX_VALUE = 127;

    /** The number of bits. */
    public static final int SIZE = 8;

    /** The class of the plain values, byte.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Byte> TYPE = (Class<Byte>) byte[].class.getComponentType();

    private final byte value;

    /** Makes an object of the number. */
    public Byte(byte value) {
        this.value = value;
    }

    /** Makes an object of the number that the text says. */
    public Byte(String text) {
        this(parseByte(text));
    }

    /** Gives an object of the number. */
    public static Byte valueOf(byte value) {
        return new Byte(value);
    }

    /** Gives an object of the number that the text says. */
    public static Byte valueOf(String text) {
        return new Byte(text);
    }

    /** Gives an object of the number that the text says in a system of so many digits. */
    public static Byte valueOf(String text, int radix) {
        return new Byte(parseByte(text, radix));
    }

    /** Gives the number that the text says; NumberFormatException if it says none. */
    public static byte parseByte(String text) {
        return parseByte(text, 10);
    }

    /** Gives the number that the text says in a system of so many digits. */
    public static byte parseByte(String text, int radix) {
        int value = Integer.parseInt(text, radix);
        if (value < MIN_VALUE || value > MAX_VALUE) throw new NumberFormatException("number is too big");
        return (byte) value;
    }

    /** Gives the number as text. */
    public static String toString(byte value) {
        return String.valueOf(value);
    }

    /** Gives the number as a byte. */
    public byte byteValue() {
        return value;
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
    public int compareTo(Byte other) {
        return value - other.value;
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Byte && ((Byte) other).value == value;
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        return value;
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }
}
