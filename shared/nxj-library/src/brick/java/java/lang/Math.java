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

    private static final double SMALL_ANGLE = PI / 4;

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

    /** Gives the nearest whole number; of two that are as near, the even one. */
    public static double rint(double number) {
        if (!(number > -WHOLE_FROM && number < WHOLE_FROM) || number == 0) return number;
        return number < 0 ? -(WHOLE_FROM - number - WHOLE_FROM) : number + WHOLE_FROM - WHOLE_FROM;
    }

    /** Gives the nearest whole number; a half goes up. */
    public static int round(float number) {
        double whole = floor(number);
        return (int) (number - whole >= 0.5 ? whole + 1 : whole);
    }

    /** Gives the nearest whole number; a half goes up. */
    public static long round(double number) {
        double whole = floor(number);
        return (long) (number - whole >= 0.5 ? whole + 1 : whole);
    }

    /** Gives the next decimal number above this one. */
    public static float nextUp(float number) {
        if (number != number || number == Float.POSITIVE_INFINITY) return number;
        if (number == 0) return Float.MIN_VALUE;
        int bits = Float.floatToRawIntBits(number);
        return Float.intBitsToFloat(number > 0 ? bits + 1 : bits - 1);
    }

    /** Gives the next decimal number above this one. */
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
        if (!(number > 0) || number == Double.POSITIVE_INFINITY) return number < 0 ? Double.NaN : number;
        long bits = Double.doubleToRawLongBits(number);
        int exponent = (int) (bits >> 52);
        long mantissa = bits & 0xFFFFFFFFFFFFFL;
        if (exponent == 0) {
            exponent = 1;
            while (mantissa < 0x10000000000000L) {
                mantissa <<= 1;
                exponent--;
            }
        } else {
            mantissa |= 0x10000000000000L;
        }
        int power = exponent - 1023;
        if ((power & 1) != 0) mantissa <<= 1;
        // The root of a number from 1 to 4, by Newton, and then its last bit by whole numbers.
        double square = mantissa / WHOLE_FROM;
        double root = 0.68 + square * 0.34;
        root = (root + square / root) / 2;
        root = (root + square / root) / 2;
        root = (root + square / root) / 2;
        root = (root + square / root) / 2;
        long whole = (long) (root * WHOLE_FROM);
        long rest = (mantissa << 52) - whole * whole;
        if (rest > whole) {
            whole++;
        } else if (rest <= -whole) {
            whole--;
        }
        return Double.longBitsToDouble(((long) ((power >> 1) + 1022) << 52) + whole);
    }

    /** Gives the sine of an angle in radians. */
    public static double sin(double angle) {
        if (angle == 0) return angle;
        if (angle >= -SMALL_ANGLE && angle <= SMALL_ANGLE) return angle + Angles.sineLessAngle(angle, 0);
        return sine(Angles.reduce(angle), 0);
    }

    /** Gives the cosine of an angle in radians. */
    public static double cos(double angle) {
        return sine(Angles.reduce(angle), 1);
    }

    /** Gives the tangent of an angle in radians. */
    public static double tan(double angle) {
        if (angle == 0) return angle;
        TwoPartNumber rest = Angles.reduce(angle);
        TwoPartNumber cosine = new TwoPartNumber();
        Angles.setCosine(rest.high, rest.low, cosine);
        cosine.setSum(cosine.high, cosine.low, 0);
        TwoPartNumber sine = new TwoPartNumber();
        sine.setSum(rest.high, Angles.sineLessAngle(rest.high, rest.low), 0);
        return (rest.quarters & 1) == 0 ? quotient(sine, cosine) : -quotient(cosine, sine);
    }

    /** Gives the angle, in radians, that has this sine. */
    public static double asin(double sine) {
        if (sine == 0) return sine;
        double height = abs(sine);
        if (!(height <= 1)) return Double.NaN;
        TwoPartNumber width = otherSide(height);
        double angle = Arcs.direction(height, width.high, -height * width.low);
        return sine < 0 ? -angle : angle;
    }

    /** Gives the angle, in radians, that has this cosine. */
    public static double acos(double cosine) {
        if (!(abs(cosine) <= 1)) return Double.NaN;
        TwoPartNumber height = otherSide(cosine);
        return Arcs.direction(height.high, cosine, cosine * height.low);
    }

    /** Gives the angle, in radians, that has this tangent. */
    public static double atan(double tangent) {
        return atan2(tangent, 1);
    }

    /** Gives the direction, in radians, of a point so far up and so far to the right. */
    public static double atan2(double up, double right) {
        if (up != up || right != right) return Double.NaN;
        boolean isDown = up < 0 || up == 0 && 1 / up < 0;
        double angle = direction(abs(up), right);
        return isDown ? -angle : angle;
    }

    /** Gives Euler's number to this power. */
    public static double exp(double power) {
        return power != power ? power : Powers.exponential(power, 0);
    }

    /** Gives the natural logarithm. */
    public static double log(double number) {
        if (number == 0) return Double.NEGATIVE_INFINITY;
        if (!(number > 0)) return Double.NaN;
        return number == Double.POSITIVE_INFINITY ? number : Powers.logarithm(number).high;
    }

    /** Gives a number to the power of another. */
    public static double pow(double number, double power) {
        if (power == 0) return 1;
        if (number != number || power != power) return Double.NaN;
        double size = abs(number);
        boolean isNegative = number < 0 || number == 0 && 1 / number < 0;
        boolean isOdd = rint(power) == power && abs(power) < 2 * WHOLE_FROM && ((long) power & 1) == 1;
        double result;
        if (size == 0 || size == Double.POSITIVE_INFINITY) {
            result = size == 0 == power > 0 ? 0 : Double.POSITIVE_INFINITY;
        } else if (abs(power) == Double.POSITIVE_INFINITY) {
            if (size == 1) return Double.NaN;
            return size > 1 == power > 0 ? Double.POSITIVE_INFINITY : 0;
        } else if (isNegative && rint(power) != power) {
            return Double.NaN;
        } else {
            result = power(size, power);
        }
        return isNegative && isOdd ? -result : result;
    }

    /** Turns an angle in radians into one in degrees. */
    public static double toDegrees(double radians) {
        return radians * 180 / PI;
    }

    /** Turns an angle in degrees into one in radians. */
    public static double toRadians(double degrees) {
        return degrees / 180 * PI;
    }

    private static synchronized Random generator() {
        if (generator == null) generator = new Random();
        return generator;
    }

    /** The sine of an angle that is so many quarters of a turn further. */
    private static double sine(TwoPartNumber angle, int quarters) {
        int quarter = angle.quarters + quarters;
        double sine;
        if ((quarter & 1) == 0) {
            sine = angle.high + Angles.sineLessAngle(angle.high, angle.low);
        } else {
            TwoPartNumber cosine = new TwoPartNumber();
            Angles.setCosine(angle.high, angle.low, cosine);
            sine = cosine.high + cosine.low;
        }
        return (quarter & 2) == 0 ? sine : -sine;
    }

    private static double quotient(TwoPartNumber a, TwoPartNumber b) {
        double quotient = a.high / b.high;
        double product = quotient * b.high;
        double rest = a.high - product - TwoPartNumber.remainder(quotient, b.high, product);
        return quotient + (rest + a.low - quotient * b.low) / b.high;
    }

    /** The third side of a triangle with a right angle, whose longest side is 1. */
    private static TwoPartNumber otherSide(double side) {
        TwoPartNumber square = new TwoPartNumber();
        double product = side * side;
        square.setSum(1, -product, -TwoPartNumber.remainder(side, side, product));
        square.setSum(square.high, square.low, 0);
        double root = sqrt(square.high);
        if (root == 0) return square;
        double rootSquared = root * root;
        double rest = square.high - rootSquared - TwoPartNumber.remainder(root, root, rootSquared) + square.low;
        square.high = root;
        square.low = rest / (2 * root);
        return square;
    }

    /** The direction of a point that is not below 0. */
    private static double direction(double up, double right) {
        if (up == 0) return right < 0 || right == 0 && 1 / right < 0 ? PI : 0;
        if (right == 0) return PI / 2;
        double width = abs(right);
        if (up == Double.POSITIVE_INFINITY) {
            if (width != Double.POSITIVE_INFINITY) return PI / 2;
            return right > 0 ? PI / 4 : 3 * PI / 4;
        }
        if (width == Double.POSITIVE_INFINITY) return right > 0 ? 0 : PI;
        double quotient = up / width;
        if (quotient > 1e18) return PI / 2;
        if (quotient < 1e-18) return right > 0 ? quotient : PI;
        // Far away from the ends of what numbers can be, so that products are exact.
        if (up > 1e150 || width > 1e150) return Arcs.direction(up * 0x1p-600, right * 0x1p-600, 0);
        if (up < 1e-150 || width < 1e-150) return Arcs.direction(up * 0x1p600, right * 0x1p600, 0);
        return Arcs.direction(up, right, 0);
    }

    private static double power(double number, double power) {
        TwoPartNumber logarithm = Powers.logarithm(number);
        double product = power * logarithm.high;
        if (!(abs(product) < 800)) return product > 0 ? Double.POSITIVE_INFINITY : 0;
        double rest = TwoPartNumber.remainder(power, logarithm.high, product) + power * logarithm.low;
        return Powers.exponential(product, rest);
    }
}
