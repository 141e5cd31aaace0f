package java.util;

/** Gives numbers by chance; the same seed gives the same numbers again. */
public class Random {
    private int previousSeed = 1;
    private int seed;

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
        int next = (seed * 48271) ^ previousSeed;
        previousSeed = seed;
        seed = next;
        return next;
    }

    /** Gives a whole number from 0 up to, but not including, the given one; fails with IllegalArgumentException if that is not above 0. */
    public int nextInt(int count) {
        if (count <= 0) throw new IllegalArgumentException();
        int rest = nextInt() % count;
        return rest < 0 ? rest + count : rest;
    }
}
