package java.lang;

/** An array cannot have fewer than 0 elements. */
public class NegativeArraySizeException extends RuntimeException {
    /** Makes one without a message. */
    public NegativeArraySizeException() {
    }

    /** Makes one that says what went wrong. */
    public NegativeArraySizeException(String message) {
        super(message);
    }
}
