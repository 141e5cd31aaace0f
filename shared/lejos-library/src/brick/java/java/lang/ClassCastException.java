package java.lang;

/** An object is not of the class it was taken for. */
public class ClassCastException extends RuntimeException {
    /** Makes one without a message. */
    public ClassCastException() {
    }

    /** Makes one that says what went wrong. */
    public ClassCastException(String message) {
        super(message);
    }
}
