package josx.util;

/** Is told each time a Timer has run down. */
public interface TimerListener {
    /** Is called each time the timer has run down. */
    void timedOut();
}
