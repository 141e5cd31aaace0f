package java.lang;

/** Something went so wrong that a program can hardly go on. */
public class Error extends Throwable {
    /** Makes one without a message. */
    public Error() {
    }

    /** Makes one that says what went wrong. */
    public Error(String message) {
        super(message);
    }
}
