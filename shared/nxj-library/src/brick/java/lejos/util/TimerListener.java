package lejos.util;

/** Is called by a Timer again and again. */
public interface TimerListener {
    /** The time is over. */
    void timedOut();
}
