package java.util;

/** A stack with nothing on it was asked for its top. */
public class EmptyStackException extends RuntimeException {
    /** Makes one without a message. */
    public EmptyStackException() {
    }

    /** Makes one that says what went wrong. */
    public EmptyStackException(String message) {
        super(message);
    }
}
