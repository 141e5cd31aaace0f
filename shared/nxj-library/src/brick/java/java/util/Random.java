package java.util;

/** Gives numbers by chance; the same seed gives the same numbers again. */
public class Random {
    private static final long FACTOR = 0x5DEECE66DL;
    private static final long MASK = (1L << 48) - 1;

    private long seed;
    private double nextGaussian;
    private boolean hasNextGaussian;

    /** Makes numbers that depend on the moment. */
    public Random() {
        this(System.nanoTime());
    }

    /** Makes the numbers that belong to a seed. */
    public Random(long seed) {
        setSeed(seed);
    }

    /** Begins with the numbers that belong to a seed. */
    public void setSeed(long seed) {
        this.seed = (seed ^ FACTOR) & MASK;
        hasNextGaussian = false;
    }

    /** Gives a number of so many bits. */
    protected int next(int bits) {
        seed = seed * FACTOR + 11 & MASK;
        return (int) (seed >>> 48 - bits);
    }

    /** Gives any whole number. */
    public int nextInt() {
        return next(32);
    }

    /** Gives a whole number from 0 up to, but not including, the given one, which must be above 0. */
    public int nextInt(int count) {
        if (count <= 0) throw new IllegalArgumentException();
        if ((count & -count) == count) return (int) ((long) count * next(31) >> 31);
        int bits;
        int value;
        do {
            bits = next(31);
            value = bits % count;
        } while (bits - value + (count - 1) < 0);
        return value;
    }

    /** Gives any whole number of 64 bits. */
    public long nextLong() {
        return ((long) next(32) << 32) + next(32);
    }

    /** Gives true or false. */
    public boolean nextBoolean() {
        return next(1) != 0;
    }

    /** Gives a number from 0 up to, but not including, 1. */
    public float nextFloat() {
        return next(24) / 16777216f;
    }

    /** Gives a number from 0 up to, but not including, 1. */
    public double nextDouble() {
        return (((long) next(26) << 27) + next(27)) / 9007199254740992d;
    }

    /** Fills the array with bytes. */
    public void nextBytes(byte[] bytes) {
        for (int index = 0; index < bytes.length;) {
            int number = nextInt();
            for (int count = 0; count < 4 && index < bytes.length; count++) {
                bytes[index++] = (byte) number;
                number >>= 8;
            }
        }
    }

    /** Gives a number that is mostly near 0: the mean is 0 and the standard deviation 1. */
    public synchronized double nextGaussian() {
        if (hasNextGaussian) {
            hasNextGaussian = false;
            return nextGaussian;
        }
        double x;
        double y;
        double square;
        do {
            x = 2 * nextDouble() - 1;
            y = 2 * nextDouble() - 1;
            square = x * x + y * y;
        } while (square >= 1 || square == 0);
        double factor = Math.sqrt(-2 * Math.log(square) / square);
        nextGaussian = y * factor;
        hasNextGaussian = true;
        return x * factor;
    }
}
