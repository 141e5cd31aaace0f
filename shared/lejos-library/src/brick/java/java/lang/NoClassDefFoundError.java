package java.lang;

/** A class is missing. */
public class NoClassDefFoundError extends Error {
    /** Makes one without a message. */
    public NoClassDefFoundError() {
    }

    /** Makes one that says what went wrong. */
    public NoClassDefFoundError(String message) {
        super(message);
    }
}
