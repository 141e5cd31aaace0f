package java.lang;

import java.util.Random;

/**
 * Mathematics, good for five to seven figures: a brick's double has only 32 bits.
 *
 * <p>Everything is worked out with 32-bit additions, multiplications and divisions, so that it is the same to the last bit everywhere. As on a
 * brick, sine and cosine are good for five figures, and floor, ceil and round are wrong for some whole numbers and halves.
 */
public final class Math {
    /** Euler's number. */
    public static final double E = 2.718281828459045;

    /** How many times a circle's width goes around it. */
    public static final double PI = 3.141592653589793;

    /** What comes of a calculation without a result. */
    public static final double NaN = 0.0 / 0.0;

    /** From here on 32-bit numbers have no figures behind the point. */
    private static final float WHOLE_FROM = 8388608f;

    // The natural logarithm of 2 as a first part with few bits, whose multiples are exact, and the rest.
    private static final float LOGARITHM_OF_2 = 0.69335938f;
    private static final float LOGARITHM_OF_2_REST = -2.1219444e-4f;

    private static final float ROOT_OF_2 = 1.4142135f;
    private static final float TANGENT_OF_EIGHTH = 0.41421357f;
    private static final float HALF_PI = 1.5707964f;

    private static Random generator;

    private Math() {
    }

    /** Gives the number without its minus. */
    public static int abs(int number) {
        return number < 0 ? -number : number;
    }

    /** Gives the number without its minus. */
    public static double abs(double number) {
        return number < 0 ? -number : number;
    }

    /** Gives the smaller of two whole numbers. */
    public static int min(int a, int b) {
        return a < b ? a : b;
    }

    /** Gives the smaller of two numbers. */
    public static double min(double a, double b) {
        return a < b ? a : b;
    }

    /** Gives the larger of two whole numbers. */
    public static int max(int a, int b) {
        return a > b ? a : b;
    }

    /** Gives the larger of two numbers. */
    public static double max(double a, double b) {
        return a > b ? a : b;
    }

    /** Gives the largest whole number that is not above the number; as on a brick, -3 for -2. */
    public static double floor(double number) {
        float value = (float) number;
        if (!(value > -WHOLE_FROM && value < WHOLE_FROM)) return value;
        return value < 0f ? (int) (value - 1f) : (int) value;
    }

    /** Gives the smallest whole number that is not below the number; as on a brick, 3 for 2. */
    public static double ceil(double number) {
        float value = (float) number;
        if (!(value > -WHOLE_FROM && value < WHOLE_FROM)) return value;
        return value < 0f ? (int) value : (int) (value + 1f);
    }

    /** Gives the nearest whole number; a half goes up, but as on a brick, one below -1 goes down. */
    public static int round(float number) {
        return (int) floor(number + 0.5f);
    }

    /** Gives a number from 0 up to, but not including, 1 by chance. */
    public static double random() {
        if (generator == null) generator = new Random();
        return (generator.nextInt() & 0xFFFFFF) / 16777216f;
    }

    /** Gives the square root, and NaN for a number below 0. */
    public static double sqrt(double number) {
        float value = (float) number;
        int bits = Float.floatToIntBits(value);
        if ((bits & 0x7FFFFFFF) == 0 || bits == 0x7F800000) return value;
        if (bits < 0 || bits > 0x7F800000) return Float.intBitsToFloat(0x7FC00000);
        int exponent = bits >> 23;
        int rest = bits & 0x7FFFFF;
        if (exponent == 0) {
            exponent = 1;
            while ((rest & 0x800000) == 0) {
                rest <<= 1;
                exponent--;
            }
        } else {
            rest |= 0x800000;
        }
        exponent -= 127;
        rest <<= (exponent & 1) + 1;
        // The root's bits one by one, the first one first, with one more than fits so that the last can be rounded.
        int root = 0;
        int taken = 0;
        for (int bit = 0x1000000; bit != 0; bit >>= 1) {
            if (taken + bit <= rest) {
                rest -= taken + bit;
                taken += bit + bit;
                root += bit;
            }
            rest <<= 1;
        }
        if (rest != 0) root += root & 1;
        return Float.intBitsToFloat((root >> 1) + ((exponent >> 1) + 126 << 23));
    }

    // Sine and cosine are quotients of polynomials: from -90 to 90 degrees the approximations of Chebyshev and Pade, of degree 3 and 4 over 4,
    // calculated with the method of Clenshaw and Lord. leJOS has the same ones, so the last digit is that of a brick.

    /** Gives the sine of an angle in radians. */
    public static double sin(double angle) {
        float value = (float) angle;
        int halves = halfTurns(value);
        float x = value - 2 * halves * HALF_PI;
        float square = x * x;
        float above = (0.92383188548f - 0.09595498074f * square) * x;
        float sine = above / (0.92384006904f + (0.05797298197f + 0.00203179118f * square) * square);
        return (halves & 1) == 0 ? sine : -sine;
    }

    /** Gives the cosine of an angle in radians. */
    public static double cos(double angle) {
        float value = (float) angle;
        int halves = halfTurns(value);
        float x = value - 2 * halves * HALF_PI;
        float square = x * x;
        float above = 0.94570925286f + (-0.43053205393f + 0.01914993011f * square) * square;
        float cosine = above / (0.94570932122f + (0.04232119631f + 0.00091063177f * square) * square);
        return (halves & 1) == 0 ? cosine : -cosine;
    }

    /** Gives the tangent of an angle in radians. */
    public static double tan(double angle) {
        return sin(angle) / cos(angle);
    }

    /** Gives the angle, in radians, that has this sine. */
    public static double asin(double sine) {
        float value = (float) sine;
        return atan2(value, sqrt((1f - value) * (1f + value)));
    }

    /** Gives the angle, in radians, that has this cosine. */
    public static double acos(double cosine) {
        float value = (float) cosine;
        return atan2(sqrt((1f - value) * (1f + value)), value);
    }

    /** Gives the angle, in radians, that has this tangent. */
    public static double atan(double tangent) {
        return atan2(tangent, 1f);
    }

    /** Gives the direction, in radians, of a point so far up and so far to the right. */
    public static double atan2(double up, double right) {
        float x = (float) right;
        float y = (float) up;
        float width = x < 0f ? -x : x;
        float height = y < 0f ? -y : y;
        float angle = 0f;
        if (height > width) {
            angle = HALF_PI - arcOf(width / height);
        } else if (width > 0f) {
            angle = arcOf(height / width);
        }
        if (x < 0f) angle = (float) PI - angle;
        return y < 0f ? -angle : angle;
    }

    /** Gives Euler's number to this power. */
    public static double exp(double power) {
        float value = (float) power;
        if (value > 89f) return Float.intBitsToFloat(0x7F800000);
        if (value < -104f) return 0f;
        float logarithm = value * 1.442695f;
        int twos = (int) (logarithm < 0f ? logarithm - 0.5f : logarithm + 0.5f);
        float rest = value - twos * LOGARITHM_OF_2 - twos * LOGARITHM_OF_2_REST;
        float result = 1f;
        for (int divisor = 8; divisor >= 1; divisor--) result = 1f + rest / divisor * result;
        int half = twos / 2;
        return result * powerOfTwo(half) * powerOfTwo(twos - half);
    }

    /** Gives the natural logarithm. */
    public static double log(double number) {
        float value = (float) number;
        int bits = Float.floatToIntBits(value);
        if ((bits & 0x7FFFFFFF) == 0) return Float.intBitsToFloat(0xFF800000);
        if (bits < 0) return Float.intBitsToFloat(0x7FC00000);
        if (bits >= 0x7F800000) return value;
        int twos = 0;
        if (bits < 0x800000) {
            bits = Float.floatToIntBits(value * WHOLE_FROM);
            twos = -23;
        }
        twos += (bits >> 23) - 127;
        float mantissa = Float.intBitsToFloat((bits & 0x7FFFFF) | 0x3F800000);
        if (mantissa > ROOT_OF_2) {
            mantissa /= 2f;
            twos++;
        }
        float s = (mantissa - 1f) / (mantissa + 1f);
        float square = s * s;
        float sum = 0f;
        for (int divisor = 11; divisor >= 1; divisor -= 2) sum = 1f / divisor + square * sum;
        return twos * LOGARITHM_OF_2 + (twos * LOGARITHM_OF_2_REST + 2f * s * sum);
    }

    /** Gives a number to the power of another. */
    public static double pow(double number, double power) {
        float base = (float) number;
        float exponent = (float) power;
        int whole = (int) exponent;
        if (whole != exponent) {
            if (base == 0f) return exponent > 0f ? 0f : 1f / base;
            return exp(exponent * log(base));
        }
        float factor = base;
        float product = 1f;
        for (int rest = abs(whole); rest != 0; rest >>>= 1) {
            if ((rest & 1) == 1) product *= factor;
            factor *= factor;
        }
        return whole < 0 ? 1f / product : product;
    }

    /** Turns an angle in radians into one in degrees. */
    public static double toDegrees(double radians) {
        return (float) radians * 57.29578f;
    }

    /** Turns an angle in degrees into one in radians. */
    public static double toRadians(double degrees) {
        return (float) degrees * 0.017453292f;
    }

    /** How many half turns have to be taken from an angle, so that less than a quarter is left in either direction. */
    private static int halfTurns(float angle) {
        int quarters = (int) (angle / HALF_PI);
        return (quarters < 0 ? quarters - 1 : quarters + 1) / 2;
    }

    /** The angle, in radians, whose tangent is from 0 to 1. */
    private static float arcOf(float tangent) {
        if (tangent > TANGENT_OF_EIGHTH) return HALF_PI / 2f + smallArcOf((tangent - 1f) / (tangent + 1f));
        return smallArcOf(tangent);
    }

    private static float smallArcOf(float tangent) {
        float square = tangent * tangent;
        float sum = 0f;
        for (int divisor = 17; divisor >= 1; divisor -= 2) sum = 1f / divisor - square * sum;
        return tangent * sum;
    }

    /** 2 to a power from -126 to 127. */
    private static float powerOfTwo(int power) {
        return Float.intBitsToFloat(power + 127 << 23);
    }
}
