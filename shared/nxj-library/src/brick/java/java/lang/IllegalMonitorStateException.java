package java.lang;

/** A thread called wait or notify of an object outside of a synchronized block. */
public class IllegalMonitorStateException extends RuntimeException {
    /** Makes one without a message. */
    public IllegalMonitorStateException() {
    }

    /** Makes one that says what went wrong. */
    public IllegalMonitorStateException(String message) {
        super(message);
    }
}
