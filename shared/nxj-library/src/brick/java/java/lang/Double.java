package java.lang;

/** A decimal number of 64 bits as an object. */
public final class Double extends Number implements Comparable<Double> {
    /** Above all numbers; what 1 divided by 0 is. */
    public static final double POSITIVE_INFINITY = 1d / 0;

    /** Below all numbers; what -1 divided by 0 is. */
    public static final double NEGATIVE_INFINITY = -1d / 0;

    /** Not a number; what 0 divided by 0 is. It is not even equal to itself. */
    public static final double NaN = 0d / 0;

    /** The highest power of 2 that a number has. */
    public static final int MAX_EXPONENT = 1023;

    /** The highest number. */
    public static final double MAX_VALUE = 0x1.fffffffffffffp+1023;

    /** The lowest power of 2 that a number with all its digits has. */
    public static final int MIN_EXPONENT = -1022;

    /** The number nearest to 0 that has all its digits. */
    public static final double MIN_NORMAL = 0x1.0p-1022;

    /** The number nearest to 0. */
    public static final double MIN_VALUE = 0x1.0p-1074;

    /** The number of bits. */
    public static final int SIZE = 64;

    /** The class of the plain values, double.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Double> TYPE = (Class<Double>) double[].class.getComponentType();

    private final double value;

    /** Makes an object of the number. */
    public Double(double value) {
        this.value = value;
    }

    /** Makes an object of the number that the text says. */
    public Double(String text) {
        this(parseDouble(text));
    }

    /** Gives an object of the number. */
    public static Double valueOf(double value) {
        return new Double(value);
    }

    /** Gives an object of the number that the text says. */
    public static Double valueOf(String text) {
        return new Double(text);
    }

    /** Gives the number that the text says; NumberFormatException if it says none, or has blanks around it. */
    public static double parseDouble(String text) {
        return DecimalReader.toDouble(text);
    }

    /** Gives the number as text, with at most 15 digits. */
    public static String toString(double value) {
        return DecimalWriter.toString(value);
    }

    /** Says whether it is not a number. */
    public static boolean isNaN(double value) {
        return value != value;
    }

    /** Says whether it is above or below all numbers. */
    public static boolean isInfinite(double value) {
        return value == POSITIVE_INFINITY || value == NEGATIVE_INFINITY;
    }

    /** Gives a number below 0 if the second one is larger, and above 0 if it is smaller; NaN is above all others. */
    public static int compare(double a, double b) {
        if (a < b) return -1;
        if (a > b) return 1;
        if (a == b && a != 0) return 0;
        long bitsOfA = doubleToLongBits(a);
        long bitsOfB = doubleToLongBits(b);
        return bitsOfA < bitsOfB ? -1 : bitsOfA > bitsOfB ? 1 : 0;
    }

    /** Gives the bits of the number; they are the same for every NaN. */
    public static long doubleToLongBits(double value) {
        return value == value ? doubleToRawLongBits(value) : 0x7FF8000000000000L;
    }

    /** Gives the bits of the number. */
    public static native long doubleToRawLongBits(double value);

    /** Gives the number that has these bits. */
    public static native double longBitsToDouble(long bits);

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
        return (float) value;
    }

    /** Gives the number as a double. */
    public double doubleValue() {
        return value;
    }

    /** Gives a number below 0 if the other one is larger, and above 0 if it is smaller. */
    public int compareTo(Double other) {
        return compare(value, other.value);
    }

    /** Says whether both are the same number. */
    public boolean equals(Object other) {
        return other instanceof Double && doubleToLongBits(((Double) other).value) == doubleToLongBits(value);
    }

    /** Gives a number that is the same for the same number. */
    public int hashCode() {
        long bits = doubleToLongBits(value);
        return (int) (bits ^ bits >>> 32);
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }
}
