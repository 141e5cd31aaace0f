package java.lang;

/** A method was given something that it cannot take. */
public class IllegalArgumentException extends RuntimeException {
    /** Makes one without a message. */
    public IllegalArgumentException() {
    }

    /** Makes one that says what went wrong. */
    public IllegalArgumentException(String message) {
        super(message);
    }

    /** Makes one that says what went wrong, and which other one caused it. */
    public IllegalArgumentException(String message, Throwable cause) {
        super(message, cause);
    }

    /** Makes one that another one caused. */
    public IllegalArgumentException(Throwable cause) {
        super(cause);
    }
}
