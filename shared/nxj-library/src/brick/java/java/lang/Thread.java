package java.lang;

import lejos.nxt.VM;

/** Something the brick does beside everything else: extend it or give it a Runnable, and call start. */
public class Thread implements Runnable {
    /** The least priority: everybody else goes first. */
    public static final int MIN_PRIORITY = 1;

    /** The priority that main has. */
    public static final int NORM_PRIORITY = 5;

    /** The highest priority: nobody else has a turn while such a thread is busy. */
    public static final int MAX_PRIORITY = 10;

    // No static initialiser here: the virtual machine makes the thread of main before any class is ready.

    // The virtual machine keeps its data in these fields, as on an RCX. It knows only their places, so their order and
    // types must stay as they are, nothing may stand before them, and Thread may extend nothing with fields.
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

    private static UncaughtExceptionHandler defaultHandler;

    private String name;
    private Runnable task;
    private UncaughtExceptionHandler handler;

    /** Makes a thread with the priority of the one that makes it. */
    public Thread() {
        this(null, "");
    }

    /** Makes a thread with a name. */
    public Thread(String name) {
        this(null, name);
    }

    /** Makes a thread that does the task. */
    public Thread(Runnable task) {
        this(task, "");
    }

    /** Makes a thread with a name that does the task. */
    public Thread(Runnable task, String name) {
        this.task = task;
        this.name = name;
        Thread maker = currentThread();
        setPriority(maker == null ? NORM_PRIORITY : maker.getPriority());
        if (maker != null) setDaemon(maker.isDaemon());
    }

    /** Does what the thread is for: write your own, or give the thread a Runnable, and let start call it. */
    public void run() {
        if (task != null) task.run();
    }

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

    /** Sets whether the program may end while this thread is still busy; call it before start. */
    public final native void setDaemon(boolean isDaemon);

    /** Waits until the thread has ended. */
    public final native void join() throws InterruptedException;

    /** Waits until the thread has ended, at most for so many milliseconds; 0 are for ever. */
    public final native void join(long milliseconds) throws InterruptedException;

    /** Says whether the thread has started and not yet ended. */
    public final boolean isAlive() {
        return state >= FIRST_STATE_ALIVE;
    }

    /** Gives the name of the thread. */
    public String getName() {
        return name == null ? "" : name;
    }

    /** Gives the thread a name. */
    public void setName(String name) {
        this.name = name;
    }

    /** Sets who is told of an exception that nobody catches, for all threads that have no handler of their own. */
    public static void setDefaultUncaughtExceptionHandler(UncaughtExceptionHandler handler) {
        defaultHandler = handler;
    }

    /** Gives the handler of all threads that have none of their own, or null. */
    public static UncaughtExceptionHandler getDefaultUncaughtExceptionHandler() {
        return defaultHandler;
    }

    /** Sets who is told of an exception that nobody catches in this thread. */
    public void setUncaughtExceptionHandler(UncaughtExceptionHandler handler) {
        this.handler = handler;
    }

    /** Gives the thread's own handler, or null. */
    public UncaughtExceptionHandler getUncaughtExceptionHandler() {
        return handler;
    }

    // The virtual machine calls it in the thread that ends with the exception.
    private static void systemUncaughtExceptionHandler(Throwable thrown, int method, int offset) {
        Thread thread = currentThread();
        UncaughtExceptionHandler handler = thread.handler == null ? defaultHandler : thread.handler;
        if (handler != null) {
            handler.uncaughtException(thread, thrown);
        } else if (!(thrown instanceof ThreadDeath)) {
            VM.firmwareExceptionHandler(thrown, method, offset);
        }
    }

    /** Is told of an exception that nobody catches. */
    public interface UncaughtExceptionHandler {
        /** Is called in the thread that ends with the exception. */
        void uncaughtException(Thread thread, Throwable thrown);
    }
}
