package java.lang;

import java.io.PrintStream;
import lejos.nxt.VM;

/**
 * What can be thrown and caught: all exceptions and errors extend it.
 *
 * <p>On a brick there are no names of classes and methods: as a text, and in the list of calls, they are numbers.
 */
public class Throwable {
    // The virtual machine sets the third of these fields if it makes the object itself.
    private String message;
    private Throwable cause;
    private int[] calls;

    /** Makes one without a message. */
    public Throwable() {
        fillInStackTrace();
    }

    /** Makes one that says what went wrong. */
    public Throwable(String message) {
        this();
        this.message = message;
    }

    /** Makes one that says what went wrong, and which other one caused it. */
    public Throwable(String message, Throwable cause) {
        this();
        this.message = message;
        this.cause = cause;
    }

    /** Makes one that another one caused. */
    public Throwable(Throwable cause) {
        this();
        this.message = cause == null ? null : cause.toString();
        this.cause = cause;
    }

    /** Notes which methods are being called now. */
    public Throwable fillInStackTrace() {
        calls = VM.createStackTrace(Thread.currentThread(), this);
        return this;
    }

    /** Gives the sentence that says what went wrong, or null if there is none. */
    public String getMessage() {
        return message;
    }

    /** Gives the sentence that says what went wrong, or null if there is none. */
    public String getLocalizedMessage() {
        return getMessage();
    }

    /** Gives what caused it, or null. */
    public Throwable getCause() {
        return cause;
    }

    /** Sets what caused it; fails if that is known already, or if it is the exception itself. */
    public Throwable initCause(Throwable cause) {
        if (this.cause != null) throw new IllegalStateException();
        if (cause == this) throw new IllegalArgumentException();
        this.cause = cause;
        return this;
    }

    /** Does nothing: a brick does not keep exceptions that another one hides. */
    public final void addSuppressed(Throwable hidden) {
    }

    /** Writes it, and the numbers of the methods that were being called, onto the display. */
    public void printStackTrace() {
        printStackTrace(System.err);
    }

    /** Writes it, and the numbers of the methods that were being called. */
    public void printStackTrace(PrintStream out) {
        for (Throwable told = this; told != null; told = told.cause) {
            out.println((told == this ? "" : "Caused by: ") + told);
            int count = told.calls == null ? 0 : told.calls.length;
            for (int index = 0; index < count; index++) {
                int call = told.calls[index];
                out.println(" at: " + (call >>> 16) + ":" + (call & 0xFFFF));
            }
        }
    }

    /** Gives a text such as "class 27", and behind it the sentence that says what went wrong. */
    public String toString() {
        return message == null ? getClass().toString() : getClass() + ": " + getLocalizedMessage();
    }
}
