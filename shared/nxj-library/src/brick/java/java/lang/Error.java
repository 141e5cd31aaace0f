package java.lang;

/** Something so bad that a program rarely catches it. */
public class Error extends Throwable {
    /** Makes one without a message. */
    public Error() {
    }

    /** Makes one that says what went wrong. */
    public Error(String message) {
        super(message);
    }

    /**
     * Makes one that says what went wrong, and what caused it.
     *
     * @hidden
     */
    public Error(String message, Throwable cause) {
        super(message, cause);
    }

    /**
     * Makes one that another one caused.
     *
     * @hidden
     */
    public Error(Throwable cause) {
        super(cause);
    }
}
