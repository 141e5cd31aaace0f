package java.lang;

/** Methods called each other too deep for the brick's memory. */
public class StackOverflowError extends Error {
    /** Makes one without a message. */
    public StackOverflowError() {
    }

    /** Makes one that says what went wrong. */
    public StackOverflowError(String message) {
        super(message);
    }
}
