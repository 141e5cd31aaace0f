package java.lang;

/** An object without Cloneable cannot be copied. */
public class CloneNotSupportedException extends Exception {
    /** Makes one without a message. */
    public CloneNotSupportedException() {
    }

    /** Makes one that says what went wrong. */
    public CloneNotSupportedException(String message) {
        super(message);
    }
}
