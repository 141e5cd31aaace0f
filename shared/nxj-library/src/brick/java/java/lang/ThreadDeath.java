package java.lang;

/** Ends a thread without anybody noticing. */
public class ThreadDeath extends Error {
    /** Makes one. */
    public ThreadDeath() {
    }
}
