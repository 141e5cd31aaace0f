package java.lang;

/** A class has changed since another one was compiled. */
public class IncompatibleClassChangeError extends LinkageError {
    /** Makes one without a message. */
    public IncompatibleClassChangeError() {
    }

    /** Makes one that says what went wrong. */
    public IncompatibleClassChangeError(String message) {
        super(message);
    }
}
