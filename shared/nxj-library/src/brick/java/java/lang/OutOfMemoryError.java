package java.lang;

/** The memory is full of objects that are still needed. */
public class OutOfMemoryError extends VirtualMachineError {
    /** Makes one without a message. */
    public OutOfMemoryError() {
    }

    /** Makes one that says what went wrong. */
    public OutOfMemoryError(String message) {
        super(message);
    }
}
