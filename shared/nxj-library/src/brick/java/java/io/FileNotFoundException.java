package java.io;

/** There is no file of this name. */
public class FileNotFoundException extends IOException {
    /** Makes one without a message. */
    public FileNotFoundException() {
    }

    /** Makes one that says what went wrong. */
    public FileNotFoundException(String message) {
        super(message);
    }
}
