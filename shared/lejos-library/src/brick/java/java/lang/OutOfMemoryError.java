package java.lang;

/** The brick's memory is full. */
public class OutOfMemoryError extends Error {
    /** Makes one without a message. */
    public OutOfMemoryError() {
    }

    /** Makes one that says what went wrong. */
    public OutOfMemoryError(String message) {
        super(message);
    }
}
