package java.lang;

/** A whole number was divided by 0. */
public class ArithmeticException extends RuntimeException {
    /** Makes one without a message. */
    public ArithmeticException() {
    }

    /** Makes one that says what went wrong. */
    public ArithmeticException(String message) {
        super(message);
    }
}
