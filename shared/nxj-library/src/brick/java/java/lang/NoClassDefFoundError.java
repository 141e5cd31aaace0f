package java.lang;

/** A class that the program needs is missing. */
public class NoClassDefFoundError extends LinkageError {
    /** Makes one without a message. */
    public NoClassDefFoundError() {
    }

    /** Makes one that says what went wrong. */
    public NoClassDefFoundError(String message) {
        super(message);
    }
}
