package java.lang;

/** Something the brick does beside everything else: extend it, write what to do in run, and call start. */
public abstract class Thread {
    /** The least priority: everybody else goes first. */
    public static final int MIN_PRIORITY = 1;

    /** The priority that main has. */
    public static final int NORM_PRIORITY = 5;

    /** The highest priority: nobody else has a turn while such a thread is busy. */
    public static final int MAX_PRIORITY = 10;

    // No static initialiser here: the virtual machine makes the thread of main before any class is ready.

    // The firmware of a brick keeps its own data in these fields. It knows only their places, so their order and types must stay as they are,
    // nothing may stand before them, and Thread may extend nothing with fields.
    private Thread next;
    private int awaited;
    private int wakeTime;
    private int frames;
    private int stack;
    private byte frameCount;
    private byte monitorCount;
    private byte number;
    private byte state;
    private byte priority;
    private byte interruption;
    private byte daemon;

    /** The states of a thread below this one are "not started yet" and "ended". */
    private static final byte FIRST_STATE_ALIVE = 2;

    private String name;

    /** Makes a thread with the priority of the one that makes it. */
    public Thread() {
        this("");
    }

    /** Makes a thread with a name. */
    public Thread(String name) {
        this.name = name;
        Thread maker = currentThread();
        setPriority(maker == null ? NORM_PRIORITY : maker.getPriority());
    }

    /** Does what the thread is for; write your own, and let start call it. */
    public abstract void run();

    /** Lets the thread begin beside this one. */
    public final native void start();

    /** Gives the other threads of the same priority their turn. */
    public static native void yield();

    /** Lets this thread do nothing for so many milliseconds. */
    public static native void sleep(long milliseconds) throws InterruptedException;

    /** Gives the thread that asks. */
    public static native Thread currentThread();

    /** Gives the priority, from 1 to 10. */
    public final native int getPriority();

    /** Sets the priority, from 1 to 10; the busy thread with the highest one always goes first. */
    public final native void setPriority(int priority);

    /** Wakes the thread with an InterruptedException if it is asleep or waiting. */
    public native void interrupt();

    /** Says whether this thread was interrupted, and forgets it. */
    public static native boolean interrupted();

    /** Says whether the thread was interrupted. */
    public final native boolean isInterrupted();

    /** Says whether the program may end while this thread is still busy. */
    public final native boolean isDaemon();

    /** Sets whether the program may end while this thread is still busy. */
    public final native void setDaemon(boolean isDaemon);

    /** Says whether the thread has started and not yet ended. */
    public final boolean isAlive() {
        return state >= FIRST_STATE_ALIVE;
    }

    /** Does nothing: a brick cannot wait for a thread's end, so ask isAlive now and then. */
    public final native void join() throws InterruptedException;

    /** Does nothing: a brick cannot wait for a thread's end, so ask isAlive now and then. */
    public final native void join(long milliseconds) throws InterruptedException;
}
