package java.lang;

import java.util.Random;

/** Mathematics: roots, powers, angles in radians and more. */
public final class Math {
    /** The circumference of a circle divided by its diameter. */
    public static final double PI = 3.141592653589793;

    /** Euler's number. */
    public static final double E = 2.718281828459045;

    /** From here on all decimal numbers are whole. */
    private static final double WHOLE_FROM = 4503599627370496d;

    /** Up to here, adding a half leaves a number that a long can hold. */
    private static final double WHOLE_LIMIT = 0x1p62;
    private static final float FLOAT_WHOLE_LIMIT = 0x1p30f;

    private static final double DEGREES_IN_A_RADIAN = 57.29577951308232;
    private static final double RADIANS_IN_A_DEGREE = 0.017453292519943295;

    /** The magic number of the inverse square root, for 64 bits. */
    private static final long INVERSE_ROOT_BITS = 0x5FE6EC85E7DE30DAL;

    private static Random generator;

    private Math() {
    }

    /** Gives the number without its minus. */
    public static int abs(int number) {
        return number < 0 ? -number : number;
    }

    /** Gives the number without its minus. */
    public static long abs(long number) {
        return number < 0 ? -number : number;
    }

    /** Gives the number without its minus. */
    public static float abs(float number) {
        return number <= 0f ? 0f - number : number;
    }

    /** Gives the number without its minus. */
    public static double abs(double number) {
        return number <= 0 ? 0 - number : number;
    }

    /** Gives the smaller of two numbers. */
    public static int min(int a, int b) {
        return a < b ? a : b;
    }

    /** Gives the smaller of two numbers. */
    public static long min(long a, long b) {
        return a < b ? a : b;
    }

    /** Gives the smaller of two numbers. */
    public static float min(float a, float b) {
        if (a != a) return a;
        if (a == 0 && b == 0) return Float.floatToRawIntBits(a) < 0 ? a : b;
        return a < b ? a : b;
    }

    /** Gives the smaller of two numbers. */
    public static double min(double a, double b) {
        if (a != a) return a;
        if (a == 0 && b == 0) return Double.doubleToRawLongBits(a) < 0 ? a : b;
        return a < b ? a : b;
    }

    /** Gives the larger of two numbers. */
    public static int max(int a, int b) {
        return a > b ? a : b;
    }

    /** Gives the larger of two numbers. */
    public static long max(long a, long b) {
        return a > b ? a : b;
    }

    /** Gives the larger of two numbers. */
    public static float max(float a, float b) {
        if (a != a) return a;
        if (a == 0 && b == 0) return Float.floatToRawIntBits(a) < 0 ? b : a;
        return a > b ? a : b;
    }

    /** Gives the larger of two numbers. */
    public static double max(double a, double b) {
        if (a != a) return a;
        if (a == 0 && b == 0) return Double.doubleToRawLongBits(a) < 0 ? b : a;
        return a > b ? a : b;
    }

    /** Gives -1 for a number below 0, 1 for one above 0, and 0 for 0. */
    public static float signum(float number) {
        return number > 0 ? 1f : number < 0 ? -1f : number;
    }

    /** Gives -1 for a number below 0, 1 for one above 0, and 0 for 0. */
    public static double signum(double number) {
        return number > 0 ? 1d : number < 0 ? -1d : number;
    }

    /** Gives the largest whole number that is not above the number. */
    public static double floor(double number) {
        if (!(number > -WHOLE_FROM && number < WHOLE_FROM) || number == 0) return number;
        double whole = (long) number;
        return whole > number ? whole - 1 : whole;
    }

    /** Gives the smallest whole number that is not below the number. */
    public static double ceil(double number) {
        return -floor(-number);
    }

    /** Gives the nearest whole number; a half goes away from 0. */
    public static double rint(double number) {
        if (number < -WHOLE_LIMIT || number > WHOLE_LIMIT) return number;
        return (double) (long) (number < 0 ? number - 0.5 : number + 0.5);
    }

    /** Gives the nearest whole number; a half goes up. */
    public static int round(float number) {
        if (number < -FLOAT_WHOLE_LIMIT || number > FLOAT_WHOLE_LIMIT) return (int) number;
        return (int) floor(number + 0.5);
    }

    /** Gives the nearest whole number; a half goes up. */
    public static long round(double number) {
        if (number < -WHOLE_LIMIT || number > WHOLE_LIMIT) return (long) number;
        return (long) floor(number + 0.5);
    }

    /**
     * Gives the next decimal number above this one.
     *
     * @hidden
     */
    public static float nextUp(float number) {
        if (number != number || number == Float.POSITIVE_INFINITY) return number;
        if (number == 0) return Float.MIN_VALUE;
        int bits = Float.floatToRawIntBits(number);
        return Float.intBitsToFloat(number > 0 ? bits + 1 : bits - 1);
    }

    /**
     * Gives the next decimal number above this one.
     *
     * @hidden
     */
    public static double nextUp(double number) {
        if (number != number || number == Double.POSITIVE_INFINITY) return number;
        if (number == 0) return Double.MIN_VALUE;
        long bits = Double.doubleToRawLongBits(number);
        return Double.longBitsToDouble(number > 0 ? bits + 1 : bits - 1);
    }

    /** Gives a number from 0 up to, but not including, 1 by chance. */
    public static double random() {
        return generator().nextDouble();
    }

    /** Gives the square root, and NaN for a number below 0. */
    public static double sqrt(double number) {
        if (!(number > 0)) return number == 0 ? number : Double.NaN;
        if (number == Double.POSITIVE_INFINITY) return number;
        boolean isSmall = number < Double.MIN_NORMAL;
        double x = isSmall ? number * 0x1p64 : number;
        // An estimate of 1 / root from the bits, three steps of Newton for it, and one for the root.
        double inverse = Double.longBitsToDouble(INVERSE_ROOT_BITS - (Double.doubleToRawLongBits(x) >> 1));
        double half = 0.5 * x;
        inverse = inverse * (1.5 - half * inverse * inverse);
        inverse = inverse * (1.5 - half * inverse * inverse);
        inverse = inverse * (1.5 - half * inverse * inverse);
        return (isSmall ? 0x1p-33 : 0.5) * (x * inverse + 1 / inverse);
    }

    /** Gives the sine of an angle in radians. */
    public static double sin(double angle) {
        return Angles.sine(angle);
    }

    /** Gives the cosine of an angle in radians. */
    public static double cos(double angle) {
        return Angles.cosine(angle);
    }

    /** Gives the tangent of an angle in radians. */
    public static double tan(double angle) {
        return Angles.tangent(angle);
    }

    /** Gives the angle, in radians, that has this sine. */
    public static double asin(double sine) {
        return Arcs.ofSine(sine);
    }

    /** Gives the angle, in radians, that has this cosine. */
    public static double acos(double cosine) {
        return Arcs.ofCosine(cosine);
    }

    /** Gives the angle, in radians, that has this tangent. */
    public static double atan(double tangent) {
        return Arcs.ofTangent(tangent);
    }

    /** Gives the direction, in radians, of a point so far up and so far to the right. */
    public static double atan2(double up, double right) {
        return Arcs.ofPoint(up, right);
    }

    /** Gives Euler's number to this power. */
    public static double exp(double power) {
        return Powers.exponential(power);
    }

    /** Gives the natural logarithm. */
    public static double log(double number) {
        return Powers.logarithm(number);
    }

    /** Gives a number to the power of another. The result may be a little too small, so round it instead of cutting it off. */
    public static double pow(double number, double power) {
        return Powers.power(number, power);
    }

    /** Turns an angle in radians into one in degrees. */
    public static double toDegrees(double radians) {
        return radians * DEGREES_IN_A_RADIAN;
    }

    /** Turns an angle in degrees into one in radians. */
    public static double toRadians(double degrees) {
        return degrees * RADIANS_IN_A_DEGREE;
    }

    private static synchronized Random generator() {
        if (generator == null) generator = new Random();
        return generator;
    }
}
