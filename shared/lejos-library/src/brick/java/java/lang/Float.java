package java.lang;

/** Looks at the 32 bits that a decimal number is made of. */
public final class Float {
    private Float() {
    }

    /** Gives the bits of a decimal number as a whole number. */
    public static native int floatToIntBits(float number);

    /** Gives the decimal number that has these bits. */
    public static native float intBitsToFloat(int bits);
}
