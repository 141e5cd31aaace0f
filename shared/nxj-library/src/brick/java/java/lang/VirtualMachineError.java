package java.lang;

/** The virtual machine cannot go on. */
public class VirtualMachineError extends Error {
    /** Makes one without a message. */
    public VirtualMachineError() {
    }

    /** Makes one that says what went wrong. */
    public VirtualMachineError(String message) {
        super(message);
    }
}
