package java.lang;

/** A text is no number. */
public class NumberFormatException extends IllegalArgumentException {
    /** Makes one without a message. */
    public NumberFormatException() {
    }

    /** Makes one that says what went wrong. */
    public NumberFormatException(String message) {
        super(message);
    }
}
