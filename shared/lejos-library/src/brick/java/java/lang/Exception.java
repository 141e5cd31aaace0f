package java.lang;

/** Something went wrong that a program can catch and deal with. */
public class Exception extends Throwable {
    /** Makes one without a message. */
    public Exception() {
    }

    /** Makes one that says what went wrong. */
    public Exception(String message) {
        super(message);
    }
}
