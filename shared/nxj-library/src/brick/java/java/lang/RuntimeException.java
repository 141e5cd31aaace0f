package java.lang;

/** Something went wrong that a program need not announce. */
public class RuntimeException extends Exception {
    /** Makes one without a message. */
    public RuntimeException() {
    }

    /** Makes one that says what went wrong. */
    public RuntimeException(String message) {
        super(message);
    }

    /** Makes one that says what went wrong, and what caused it. */
    public RuntimeException(String message, Throwable cause) {
        super(message, cause);
    }

    /** Makes one that another one caused. */
    public RuntimeException(Throwable cause) {
        super(cause);
    }
}
