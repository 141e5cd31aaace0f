package java.io;

/** A text is not in the form in which texts are written. */
public class UTFDataFormatException extends IOException {
    /** Makes one without a message. */
    public UTFDataFormatException() {
    }

    /** Makes one that says what went wrong. */
    public UTFDataFormatException(String message) {
        super(message);
    }
}
