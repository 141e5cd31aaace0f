package java.lang;

/** Takes quarters of a turn from angles that are so large that all their bits count. */
final class LargeAngles {
    /** The number of quarters in a radian, divided by 2 to the power of 64, in bits behind the point. */
    private static final int[] QUARTERS_PER_RADIAN = {
        0x00000000, 0x00000000, 0xA2F9836E, 0x4E441529, 0xFC2757D1, 0xF534DDC0, 0xDB629599, 0x3C439041, 0xFE5163AB,
        0xDEBBC561, 0xB7246E3A, 0x424DD2E0, 0x06492EEA, 0x09D1921C, 0xFE1DEB1C, 0xB129A73E, 0xE88235F5, 0x2EBB4484,
        0xE99C7026, 0xB45F7E41, 0x3991D639, 0x835339F4, 0x9C845F8B, 0xBDF9283B, 0x1FF897FF, 0xDE05980F, 0xEF2F118B,
        0x5A0A6D1F, 0x6D367ECF, 0x27CB09B7, 0x4F463F66, 0x9E5FEA2D, 0x7527BAC7, 0xEBE5F17B, 0x3D0739F7, 0x8A5292EA,
        0x6BFB5FB1, 0x1F8D5D08, 0x56033046, 0xFC7B6BAB};

    private static final int WORDS = 7;
    private static final long WORD = 0xFFFFFFFFL;
    private static final double WORD_SIZE = 4294967296d;
    private static final double QUARTER = 1.5707963267948966;
    private static final double QUARTER_REST = 6.123233995736766e-17;

    private LargeAngles() {
    }

    static void reduce(double angle, TwoPartNumber rest) {
        long bits = Double.doubleToRawLongBits(angle);
        int exponent = (int) (bits >>> 52) & 0x7FF;
        if (exponent == 0x7FF) {
            rest.high = Double.NaN;
            return;
        }
        long mantissa = bits & 0xFFFFFFFFFFFFFL | 0x10000000000000L;
        // The angle is mantissa times 2 to this power, and 4 quarters more or less make no difference.
        int skipped = exponent - 1075 + 64 - 2;
        int[] turn = multiply(mantissa, skipped);
        int quarters = turn[0] >>> 30;
        // What is left, as a number from 0 to 1, in quarters; more than a half is a number below 0.
        double fraction = (turn[0] & 0x3FFFFFFF) / 1073741824d;
        boolean isUp = fraction >= 0.5;
        if (isUp) {
            quarters++;
            for (int index = 0; index < WORDS; index++) turn[index] = ~turn[index];
        }
        double part = 1 / 1073741824d;
        double sign = isUp == angle > 0 ? -1 : 1;
        rest.high = (turn[0] & 0x3FFFFFFF) * part;
        for (int index = 1; index < WORDS - 1; index++) {
            part /= WORD_SIZE;
            rest.setSum(rest.high, (turn[index] & WORD) * part, rest.low);
        }
        double high = sign * rest.high;
        double low = sign * rest.low;
        rest.setProduct(high, QUARTER, high * QUARTER_REST + low * QUARTER);
        rest.setSum(rest.high, rest.low, 0);
        rest.quarters = angle > 0 ? quarters : -quarters;
    }

    /** The product of the mantissa and the bits of the table behind so many; what is 1 or more is left out. */
    private static int[] multiply(long mantissa, int skipped) {
        int[] product = new int[WORDS];
        int first = skipped >> 5;
        int shift = skipped & 31;
        long lower = mantissa & WORD;
        long upper = mantissa >>> 32;
        long carry = 0;
        for (int index = WORDS - 1; index >= 0; index--) {
            long word = wordAt(first + index, shift);
            long below = index + 1 < WORDS ? wordAt(first + index + 1, shift) : 0;
            long a = lower * word;
            long b = upper * below;
            long sum = (a & WORD) + (b & WORD) + (carry & WORD);
            product[index] = (int) sum;
            carry = (carry >>> 32) + (a >>> 32) + (b >>> 32) + (sum >>> 32);
        }
        return product;
    }

    private static long wordAt(int index, int shift) {
        long word = QUARTERS_PER_RADIAN[index] & WORD;
        if (shift == 0) return word;
        long next = index + 1 < QUARTERS_PER_RADIAN.length ? QUARTERS_PER_RADIAN[index + 1] & WORD : 0;
        return (word << shift | next >>> 32 - shift) & WORD;
    }
}
