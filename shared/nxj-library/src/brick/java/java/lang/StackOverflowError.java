package java.lang;

/** Methods have called methods too many times. */
public class StackOverflowError extends VirtualMachineError {
    /** Makes one without a message. */
    public StackOverflowError() {
    }

    /** Makes one that says what went wrong. */
    public StackOverflowError(String message) {
        super(message);
    }
}
