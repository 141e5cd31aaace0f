package java.util;

/** Something that a Timer does: extend it and write run. */
public abstract class TimerTask implements Runnable {
    long time;
    long period;
    boolean isAtFixedRate;
    boolean isCancelled;

    /** Makes one. */
    protected TimerTask() {
    }

    /** Does what the task is for. */
    public abstract void run();

    /** Lets the timer not do it any more, and says whether it would have. */
    public boolean cancel() {
        boolean wasWaiting = !isCancelled;
        isCancelled = true;
        return wasWaiting;
    }

    /** Gives when it was to be done last, as currentTimeMillis gives it. */
    public long scheduledExecutionTime() {
        return period > 0 ? time - period : time;
    }
}
