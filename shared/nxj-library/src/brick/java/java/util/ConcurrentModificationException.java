package java.util;

/** A list was changed while somebody went through it. */
public class ConcurrentModificationException extends RuntimeException {
    /** Makes one without a message. */
    public ConcurrentModificationException() {
    }

    /** Makes one that says what went wrong. */
    public ConcurrentModificationException(String message) {
        super(message);
    }
}
