package java.io;

/** Reading or writing has failed. */
public class IOException extends Exception {
    /** Makes one without a message. */
    public IOException() {
    }

    /** Makes one that says what went wrong. */
    public IOException(String message) {
        super(message);
    }

    /**
     * Makes one that says what went wrong, and what caused it.
     *
     * @hidden
     */
    public IOException(String message, Throwable cause) {
        super(message, cause);
    }

    /**
     * Makes one that another one caused.
     *
     * @hidden
     */
    public IOException(Throwable cause) {
        super(cause);
    }
}
