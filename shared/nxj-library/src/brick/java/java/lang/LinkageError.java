package java.lang;

/** Classes do not fit together. */
public class LinkageError extends Error {
    /** Makes one without a message. */
    public LinkageError() {
    }

    /** Makes one that says what went wrong. */
    public LinkageError(String message) {
        super(message);
    }
}
