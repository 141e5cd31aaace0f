/** Calculates with thousands of random numbers of all kinds, and prints what depends on all results. */
public class RandomNumbers {
    static long state = 88172645463325252L;
    static long hash;
    static double kept;
    long[] longs = new long[3];
    double[] doubles = new double[3];
    long field;

    static long random() {
        state ^= state << 13;
        state ^= state >>> 7;
        state ^= state << 17;
        return state;
    }

    static void add(long value) {
        hash = hash * 1000003 + value;
    }

    static void add(double value) {
        add(Double.doubleToLongBits(value));
    }

    static void add(float value) {
        add((long) Float.floatToIntBits(value));
    }

    public static void main(String[] args) {
        for (int i = 0; i < 700; i++) whole(i % 3 == 0 ? random() : random() >> (i & 63), random() >> (i * 7 & 63));
        System.out.println(hash); // expect 8648755344747962182
        for (int i = 0; i < 700; i++) decimal(number(i), number(i / 3));
        System.out.println(hash); // expect 1039063015222929017
        RandomNumbers numbers = new RandomNumbers();
        for (int i = 0; i < 300; i++) numbers.places(random(), i);
        System.out.println(hash); // expect -6808876407841938529
    }

    static double number(int i) {
        switch (i % 7) {
            case 0: return random() / 1000.0;
            case 1: return (int) random() >> (i & 31);
            case 2: return 1.0 / random();
            case 3: return (float) random();
            case 4: return Double.longBitsToDouble(random() >>> (i & 15));
            case 5: return i % 2 == 0 ? -0.0 : 0;
            default: return Double.longBitsToDouble(random());
        }
    }

    static void whole(long a, long b) {
        add(a + b);
        add(a - b);
        add(a * b);
        if (b != 0) add(a / b);
        if (b != 0) add(a % b);
        add(-a);
        add(~a);
        add(a << b);
        add(a >> (int) b);
        add(a >>> b);
        add(a & b);
        add(a | b);
        add(a ^ b);
        add(a < b ? 1 : a == b ? 0 : -1);
        add((int) a);
        add((long) (int) b);
        add((float) a);
        add((double) a);
        int x = (int) a;
        int y = (int) b;
        if (y != 0) add(x / y);
        if (y != 0) add(x % y);
        add(x * y);
        add((byte) x + (short) y + (char) x);
        add((float) x);
        add((double) y);
        add(x >>> y);
    }

    static void decimal(double a, double b) {
        add(a + b);
        add(a - b);
        add(a * b);
        add(a / b);
        add(a % b);
        add(-a);
        add((a < b ? 1 : 0) + (a <= b ? 2 : 0) + (a > b ? 4 : 0) + (a >= b ? 8 : 0) + (a == b ? 16 : 0) + (a != b ? 32 : 0));
        add((long) a);
        add((int) b);
        add((float) a);
        float x = (float) a;
        float y = (float) b;
        add(x + y);
        add(x * y);
        add(x / y);
        add(x % y);
        add((x < y ? 1 : 0) + (x >= y ? 2 : 0) + (x == y ? 4 : 0));
        add((long) x);
        add((int) y);
        add((double) x);
        add(x);
        add((int) (a * 1000) % 17);
        kept += a;
        if (kept != kept) kept = b;
        add(kept);
    }

    void places(long value, int i) {
        longs[i % 3] += value;
        doubles[i % 3] -= value >> 20;
        field ^= longs[(i + 1) % 3];
        longs[2] = field++;
        add(field);
        add(longs[0] + longs[1]);
        add(doubles[0] * doubles[2]);
        long swapped = longs[0];
        longs[0] = longs[1] = swapped;
        add(second(i, value, doubles[1], i + 1));
    }

    static double second(int a, long b, double c, int d) {
        return d > a ? c + b : b;
    }
}
