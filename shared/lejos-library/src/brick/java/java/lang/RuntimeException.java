package java.lang;

/** Something went wrong that may happen anywhere, so nobody has to announce it with throws. */
public class RuntimeException extends Exception {
    /** Makes one without a message. */
    public RuntimeException() {
    }

    /** Makes one that says what went wrong. */
    public RuntimeException(String message) {
        super(message);
    }
}
