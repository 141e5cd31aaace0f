package josx.util;

/**
 * Calls a listener again and again after so many milliseconds.
 *
 * <p>A thread of its own, made by the first start, does it, so the calls drift by what the listener takes. That thread is no daemon: end the
 * program with System.exit. While the timer is stopped the thread only gives its turns away, as on a brick, and threads of a lower
 * priority get none.
 */
public class Timer {
    private final TimerListener listener;
    private int delay;
    private boolean isRunning;
    private Ticks ticks;

    /** Makes one that stands still until start is called. */
    public Timer(int delay, TimerListener listener) {
        this.delay = delay;
        this.listener = listener;
    }

    /** Lets the timer run; from then on the program does not end by itself. */
    public synchronized void start() {
        isRunning = true;
        if (ticks != null) return;
        ticks = new Ticks();
        ticks.start();
    }

    /** Lets the timer stand still. */
    public synchronized void stop() {
        isRunning = false;
    }

    /** Gives the milliseconds between two calls. */
    public synchronized int getDelay() {
        return delay;
    }

    /** Sets the milliseconds between two calls. */
    public synchronized void setDelay(int delay) {
        this.delay = delay;
    }

    private class Ticks extends Thread {
        public void run() {
            while (true) {
                if (isRunning) {
                    pause(delay);
                    if (isRunning) listener.timedOut();
                } else {
                    Thread.yield();
                }
            }
        }

        private void pause(int milliseconds) {
            try {
                Thread.sleep(milliseconds);
            } catch (InterruptedException itTicksEarly) {
                // Nobody has this thread to interrupt it.
            }
        }
    }
}
