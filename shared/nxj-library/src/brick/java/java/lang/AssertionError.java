package java.lang;

/** What the program asserts is not so. */
public class AssertionError extends Error {
    /** Makes one without a message. */
    public AssertionError() {
    }

    /** Makes one that says what went wrong. */
    public AssertionError(String message) {
        super(message);
    }

    /** Makes one with the value as its message. */
    public AssertionError(Object message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(boolean message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(char message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(int message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(long message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(float message) {
        super(String.valueOf(message));
    }

    /** Makes one with the value as its message. */
    public AssertionError(double message) {
        super(String.valueOf(message));
    }
}
