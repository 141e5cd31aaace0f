package java.lang;

/** There is no object, but null. */
public class NullPointerException extends RuntimeException {
    /** Makes one without a message. */
    public NullPointerException() {
    }

    /** Makes one that says what went wrong. */
    public NullPointerException(String message) {
        super(message);
    }
}
