package java.lang;

/** An array has no such place. */
public class ArrayIndexOutOfBoundsException extends IndexOutOfBoundsException {
    /** Makes one without a message. */
    public ArrayIndexOutOfBoundsException() {
    }

    /** Makes one that names the place. */
    public ArrayIndexOutOfBoundsException(int place) {
        super("Array index out of range: " + place);
    }

    /** Makes one that says what went wrong. */
    public ArrayIndexOutOfBoundsException(String message) {
        super(message);
    }
}
