package java.io;

/** There is nothing more to read. */
public class EOFException extends IOException {
    /** Makes one without a message. */
    public EOFException() {
    }

    /** Makes one that says what went wrong. */
    public EOFException(String message) {
        super(message);
    }
}
