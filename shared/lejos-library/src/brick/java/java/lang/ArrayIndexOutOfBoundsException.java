package java.lang;

/** An array has no element with that number. */
public class ArrayIndexOutOfBoundsException extends RuntimeException {
    /** Makes one without a message. */
    public ArrayIndexOutOfBoundsException() {
    }

    /** Makes one that says what went wrong. */
    public ArrayIndexOutOfBoundsException(String message) {
        super(message);
    }
}
