package java.util;

/** There is no further element. */
public class NoSuchElementException extends RuntimeException {
    /** Makes one without a message. */
    public NoSuchElementException() {
    }

    /** Makes one that says what went wrong. */
    public NoSuchElementException(String message) {
        super(message);
    }
}
