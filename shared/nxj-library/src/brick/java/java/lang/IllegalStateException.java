package java.lang;

/** A method was called at the wrong time. */
public class IllegalStateException extends RuntimeException {
    /** Makes one without a message. */
    public IllegalStateException() {
    }

    /** Makes one that says what went wrong. */
    public IllegalStateException(String message) {
        super(message);
    }
}
