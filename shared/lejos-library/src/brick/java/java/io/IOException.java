package java.io;

/** Reading or writing did not work. */
public class IOException extends Exception {
    /** Makes one without a message. */
    public IOException() {
    }

    /** Makes one that says what went wrong. */
    public IOException(String message) {
        super(message);
    }
}
