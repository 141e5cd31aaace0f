package java.lang;

/** A field that the program needs is missing. */
public class NoSuchFieldError extends IncompatibleClassChangeError {
    /** Makes one without a message. */
    public NoSuchFieldError() {
    }

    /** Makes one that says what went wrong. */
    public NoSuchFieldError(String message) {
        super(message);
    }
}
