package java.lang;

/** A list or a text has no such place. */
public class IndexOutOfBoundsException extends RuntimeException {
    /** Makes one without a message. */
    public IndexOutOfBoundsException() {
    }

    /** Makes one that says what went wrong. */
    public IndexOutOfBoundsException(String message) {
        super(message);
    }
}
