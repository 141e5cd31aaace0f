package java.lang;

/** Something that a thread can do. */
public interface Runnable {
    /** Does it. */
    void run();
}
