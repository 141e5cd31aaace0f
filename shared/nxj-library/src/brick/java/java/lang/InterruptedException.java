package java.lang;

/** Another thread woke this one while it was asleep or waiting. */
public class InterruptedException extends Exception {
    /** Makes one without a message. */
    public InterruptedException() {
    }

    /** Makes one that says what went wrong. */
    public InterruptedException(String message) {
        super(message);
    }
}
