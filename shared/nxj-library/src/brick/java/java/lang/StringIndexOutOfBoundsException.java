package java.lang;

/** A text has no such place. */
public class StringIndexOutOfBoundsException extends IndexOutOfBoundsException {
    /** Makes one without a message. */
    public StringIndexOutOfBoundsException() {
    }

    /** Makes one that names the place. */
    public StringIndexOutOfBoundsException(int place) {
        super("String index out of range: " + place);
    }

    /** Makes one that says what went wrong. */
    public StringIndexOutOfBoundsException(String message) {
        super(message);
    }
}
