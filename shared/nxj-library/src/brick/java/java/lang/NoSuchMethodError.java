package java.lang;

/** A method that the program needs is missing. */
public class NoSuchMethodError extends IncompatibleClassChangeError {
    /** Makes one without a message. */
    public NoSuchMethodError() {
    }

    /** Makes one that says what went wrong. */
    public NoSuchMethodError(String message) {
        super(message);
    }
}
