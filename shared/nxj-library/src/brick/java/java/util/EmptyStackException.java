package java.util;

/** The stack is empty. */
public class EmptyStackException extends RuntimeException {
    /** Makes one without a message. */
    public EmptyStackException() {
    }

    /**
     * Makes one that says what went wrong.
     *
     * @hidden
     */
    public EmptyStackException(String message) {
        super(message);
    }
}
