package java.util;

/**
 * Gives numbers by chance; the same seed gives the same numbers again.
 *
 * <p>A brick makes them in a simple way, and not like a computer. Of three numbers in a row, two are always odd, so
 * nextBoolean repeats. For a coin, better ask whether nextInt(100) is below 50, and for a die, take
 * nextInt(600) / 100.
 */
public class Random {
    private static final int FACTOR = 48271;
    private static final int BITS = 32;

    private int seed;
    private int before = 1;
    private double nextGaussian;
    private boolean hasNextGaussian;

    /** Makes numbers that depend on the moment. */
    public Random() {
        this(System.currentTimeMillis());
    }

    /** Makes the numbers that belong to a seed. */
    public Random(long seed) {
        this.seed = (int) seed;
    }

    /** Gives any whole number. */
    public int nextInt() {
        int next = seed * FACTOR ^ before;
        before = seed;
        seed = next;
        return next;
    }

    /** Gives a whole number from 0 up to, but not including, the given one, which must be above 0. */
    public int nextInt(int count) {
        int rest = nextInt() % count;
        return rest < 0 ? rest + count : rest;
    }

    /** Gives any whole number of 64 bits. */
    public long nextLong() {
        long high = nextInt();
        return (high << BITS) + nextInt();
    }

    /** Gives true or false; three in a row repeat for ever. */
    public boolean nextBoolean() {
        return next(1) == 1;
    }

    /** Gives a number from 0 up to, but not including, 1. */
    public float nextFloat() {
        return next(24) / 16777216f;
    }

    /** Gives a number from 0 up to, but not including, 1. */
    public double nextDouble() {
        long high = next(26);
        return (high << 27 | next(27)) / 9007199254740992d;
    }

    /** Gives a number that is mostly near 0: the mean is 0 and the standard deviation 1. */
    public double nextGaussian() {
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

    /**
     * Gives the numbers from here on that belong to a seed.
     *
     * @hidden
     */
    public void setSeed(long seed) {
        this.seed = (int) seed;
        before = 1;
        hasNextGaussian = false;
    }

    /**
     * Fills an array with numbers.
     *
     * @hidden
     */
    public void nextBytes(byte[] bytes) {
        for (int index = 0; index < bytes.length; index++) bytes[index] = (byte) nextInt();
    }

    /** The lowest bits of the next number. */
    private int next(int bits) {
        return nextInt() & (1 << bits) - 1;
    }
}
