package java.lang;

/** The object cannot do this. */
public class UnsupportedOperationException extends RuntimeException {
    /** Makes one without a message. */
    public UnsupportedOperationException() {
    }

    /** Makes one that says what went wrong. */
    public UnsupportedOperationException(String message) {
        super(message);
    }
}
