package java.lang;

/** Something went wrong that a program has to catch or announce. */
public class Exception extends Throwable {
    /** Makes one without a message. */
    public Exception() {
    }

    /** Makes one that says what went wrong. */
    public Exception(String message) {
        super(message);
    }

    /** Makes one that says what went wrong, and what caused it. */
    public Exception(String message, Throwable cause) {
        super(message, cause);
    }

    /** Makes one that another one caused. */
    public Exception(Throwable cause) {
        super(cause);
    }
}
