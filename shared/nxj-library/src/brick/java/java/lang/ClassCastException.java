package java.lang;

/** An object does not have the class that the program takes it for. */
public class ClassCastException extends RuntimeException {
    /** Makes one without a message. */
    public ClassCastException() {
    }

    /** Makes one that says what went wrong. */
    public ClassCastException(String message) {
        super(message);
    }
}
