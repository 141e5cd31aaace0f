package java.lang;

/**
 * What can be thrown and caught: all exceptions and errors extend it.
 *
 * <p>It knows its message and no more: on a brick there are no names of classes, no list of calls and no cause.
 */
public class Throwable {
    private String message;

    /** Makes one without a message. */
    public Throwable() {
    }

    /** Makes one that says what went wrong. */
    public Throwable(String message) {
        this.message = message;
    }

    /** Gives the sentence that says what went wrong, or null if there is none. */
    public String getMessage() {
        return message;
    }

    /** Gives the sentence that says what went wrong, or an empty text if there is none. */
    public String toString() {
        return message == null ? "" : message;
    }
}
