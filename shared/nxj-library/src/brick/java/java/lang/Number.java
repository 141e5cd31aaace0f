package java.lang;

/** What all numbers are that are objects. */
public abstract class Number {
    /** Makes a number. */
    public Number() {
    }

    /** Gives the number as an int; what does not fit is cut off. */
    public abstract int intValue();

    /** Gives the number as a long; what does not fit is cut off. */
    public abstract long longValue();

    /** Gives the number as a float. */
    public abstract float floatValue();

    /** Gives the number as a double. */
    public abstract double doubleValue();

    /** Gives the number as a byte; what does not fit is cut off. */
    public byte byteValue() {
        return (byte) intValue();
    }

    /** Gives the number as a short; what does not fit is cut off. */
    public short shortValue() {
        return (short) intValue();
    }
}
