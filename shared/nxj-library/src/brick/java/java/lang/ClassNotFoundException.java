package java.lang;

/** There is no class of this name. */
public class ClassNotFoundException extends Exception {
    /** Makes one without a message. */
    public ClassNotFoundException() {
    }

    /** Makes one that says what went wrong. */
    public ClassNotFoundException(String message) {
        super(message);
    }
}
