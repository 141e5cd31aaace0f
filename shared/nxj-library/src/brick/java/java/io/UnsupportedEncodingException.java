package java.io;

/** Texts are not written in this way here. */
public class UnsupportedEncodingException extends IOException {
    /** Makes one without a message. */
    public UnsupportedEncodingException() {
    }

    /** Makes one that says what went wrong. */
    public UnsupportedEncodingException(String message) {
        super(message);
    }
}
