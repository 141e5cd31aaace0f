package lejos.util;

/**
 * Calls a listener again and again after so many milliseconds.
 *
 * <p>A thread of its own does it, so the calls drift by what the listener takes. The program may end nevertheless.
 */
public class Timer {
    private final TimerListener listener;
    private int delay;
    private boolean isRunning;

    /** Makes one that stands still until start is called. */
    public Timer(int delay, TimerListener listener) {
        this.delay = delay;
        this.listener = listener;
        Thread ticks = new Ticks();
        ticks.setDaemon(true);
        ticks.start();
    }

    /** Lets the timer run. */
    public synchronized void start() {
        isRunning = true;
    }

    /** Lets the timer stand still; the listener is called once more if it is being waited for. */
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
        Ticks() {
        }

        public void run() {
            while (true) {
                if (isRunning) {
                    Delay.msDelay(delay);
                    listener.timedOut();
                } else {
                    Thread.yield();
                }
            }
        }
    }
}
