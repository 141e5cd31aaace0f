package java.util;

/** A queue with nobody in it was asked for its first. */
public class EmptyQueueException extends RuntimeException {
    /** Makes one without a message. */
    public EmptyQueueException() {
    }

    /** Makes one that says what went wrong. */
    public EmptyQueueException(String message) {
        super(message);
    }
}
