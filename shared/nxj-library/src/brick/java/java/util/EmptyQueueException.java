package java.util;

/** The queue is empty. */
public class EmptyQueueException extends RuntimeException {
    /** Makes one without a message. */
    public EmptyQueueException() {
    }

    /**
     * Makes one that says what went wrong.
     *
     * @hidden
     */
    public EmptyQueueException(String message) {
        super(message);
    }
}
