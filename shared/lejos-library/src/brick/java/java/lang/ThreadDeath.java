package java.lang;

/** A thread is to end. */
public class ThreadDeath extends Error {
    /** Makes one without a message. */
    public ThreadDeath() {
    }

    /** Makes one that says what went wrong. */
    public ThreadDeath(String message) {
        super(message);
    }
}
