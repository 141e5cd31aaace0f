package java.lang;

/** A class has no such method. */
public class NoSuchMethodError extends Error {
    /** Makes one without a message. */
    public NoSuchMethodError() {
    }

    /** Makes one that says what went wrong. */
    public NoSuchMethodError(String message) {
        super(message);
    }
}
