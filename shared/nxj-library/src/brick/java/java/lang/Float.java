package java.lang;

/** A decimal number of 32 bits as an object. */
public final class Float extends Number implements Comparable<Float> {
    /** Above all numbers; what 1 divided by 0 is. */
    public static final float POSITIVE_INFINITY = 1f / 0;

    /** Below all numbers; what -1 divided by 0 is. */
    public static final float NEGATIVE_INFINITY = -1f / 0;

    /** Not a number; what 0 divided by 0 is. It is not even equal to itself. */
    public static final float NaN = 0f / 0;

    /** The highest power of 2 that a number has. */
    public static final int MAX_EXPONENT = 127;

    /** The highest number. */
    public static final float MAX_VALUE = 0x1.fffffep+127f;

    /** The lowest power of 2 that a number with all its digits has. */
    public static final int MIN_EXPONENT = -126;

    /** The number nearest to 0 that has all its digits. */
    public static final float MIN_NORMAL = 0x1.0p-126f;

    /** The number nearest to 0. */
    public static final float MIN_VALUE = 0x1.0p-149f;

    /** The number of bits. */
    public static final int SIZE = 32;

    /** The class of the plain values, float.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Float> TYPE = (Class<Float>) float[].class.getComponentType();

    private final float value;

    /** Makes an object of the number. */
    public Float(float value) {
        this.value = value;
    }

    /** Makes an object of the number. */
    public Float(double value) {
        this((float) value);
    }

    /** Makes an object of the number that the text says. */
    public Float(String text) {
        this(parseFloat(text));
    }

    /** Gives an object of the number. */
    public static Float valueOf(float value) {
        return new Float(value);
    }

    /** Gives an object of the number that the text says. */
    public static Float valueOf(String text) {
        return new Float(text);
    }

    /** Gives the number that the text says; NumberFormatException if it says none, or has blanks around it. */
    public static float parseFloat(String text) {
        return DecimalReader.toFloat(text);
    }

    /** Gives the number as text, with at most 7 digits. */
    public static String toString(float value) {
        return DecimalWriter.toString(value);
    }

    /** Says whether it is not a number. */
    public static boolean isNaN(float value) {
        return value != value;
    }

    /** Says whether it is above or below all numbers. */
    public static boolean isInfinite(float value) {
        return value == POSITIVE_INFINITY || value == NEGATIVE_INFINITY;
    }

    /** Gives a number below 0 if the second one is larger, and above 0 if it is smaller; NaN is above all others. */
    public static int compare(float a, float b) {
        if (a < b) return -1;
        if (a > b) return 1;
        if (a == b && a != 0) return 0;
        int bitsOfA = floatToIntBits(a);
        int bitsOfB = floatToIntBits(b);
        return bitsOfA < bitsOfB ? -1 : bitsOfA > bitsOfB ? 1 : 0;
    }

    /** Gives the bits of the number; they are the same for every NaN. */
    public static int floatToIntBits(float value) {
        return value == value ? floatToRawIntBits(value) : 0x7FC00000;
    }

    /** Gives the bits of the number. */
    public static native int floatToRawIntBits(float value);

    /** Gives the number that has these bits. */
    public static native float intBitsToFloat(int bits);

    /** Says whether it is not a number. */
    public boolean isNaN() {
        return isNaN(value);
    }

    /** Says whether it is above or below all numbers. */
    public boolean isInfinite() {
        return isInfinite(value);
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
        return (long) value;
    }

    /** Gives the number as a float. */
    public float floatValue() {
        return value;
    }

    /** Gives the number as a double. */
    public double doubleValue() {
        return (double) value;
    }

    /** Gives a number below 0 if the other one is larger, and above 0 if it is smaller. */
    public int compareTo(Float other) {
        return compare(value, other.value);
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Float && floatToIntBits(((Float) other).value) == floatToIntBits(value);
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        return floatToIntBits(value);
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }
}
