package java.lang;

/** A method or field was asked of null, that is, of no object. */
public class NullPointerException extends RuntimeException {
    /** Makes one without a message. */
    public NullPointerException() {
    }

    /** Makes one that says what went wrong. */
    public NullPointerException(String message) {
        super(message);
    }
}
