package lejos.util;

/** Measures how long something takes. */
public class Stopwatch {
    private long start;

    /** Makes one that begins now. */
    public Stopwatch() {
        reset();
    }

    /** Begins anew. */
    public void reset() {
        start = System.currentTimeMillis();
    }

    /** Gives the milliseconds since it began. */
    public int elapsed() {
        return (int) (System.currentTimeMillis() - start);
    }
}
