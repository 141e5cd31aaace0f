package java.lang;

/** An object was put into an array of another class. */
public class ArrayStoreException extends RuntimeException {
    /** Makes one without a message. */
    public ArrayStoreException() {
    }

    /**
     * Makes one that says what went wrong.
     *
     * @hidden
     */
    public ArrayStoreException(String message) {
        super(message);
    }
}
