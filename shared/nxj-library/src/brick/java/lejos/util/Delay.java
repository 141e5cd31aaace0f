package lejos.util;

/** Waits; nothing can interrupt it. */
public class Delay {
    /** Makes one; nothing needs it, since all of its methods are static. */
    public Delay() {
    }

    /** Waits so many milliseconds. */
    public static void msDelay(long period) {
        if (period <= 0) return;
        long end = System.currentTimeMillis() + period;
        long rest = period;
        boolean wasInterrupted = false;
        while (rest > 0) {
            try {
                Thread.sleep(rest);
                rest = 0;
            } catch (InterruptedException goOnWaiting) {
                wasInterrupted = true;
                rest = end - System.currentTimeMillis();
            }
        }
        if (wasInterrupted) Thread.currentThread().interrupt();
    }

    /** Waits so many millionths of a second. */
    public static void usDelay(long period) {
        nsDelay(period * 1000);
    }

    /** Waits so many billionths of a second. */
    public static void nsDelay(long period) {
        long end = System.nanoTime() + period;
        msDelay(period / 1000000);
        while (System.nanoTime() < end) Thread.yield();
    }
}
