package java.lang;

/** Knows how full the brick's memory is, and what to do when the program ends. */
public class Runtime {
    private static final Runtime ONLY = new Runtime();

    private Runtime() {
    }

    /** Gives the only object of this class. */
    public static Runtime getRuntime() {
        return ONLY;
    }

    /** Gives the bytes of memory that are free. */
    public native long freeMemory();

    /** Gives the bytes of memory that a program has for its objects. */
    public native long totalMemory();

    /**
     * Frees the memory of objects that nobody needs any more.
     *
     * @hidden
     */
    public void gc() {
        System.gc();
    }

    /** Ends the program. */
    public void exit(int code) {
        Shutdown.exit(code);
    }

    /** Ends the program at once, without the threads of addShutdownHook. */
    public void halt(int code) {
        Shutdown.halt(code);
    }

    /** Lets a thread that has not started yet run when the program ends. */
    public void addShutdownHook(Thread hook) {
        Shutdown.add(hook);
    }

    /** Does not let a thread run when the program ends, and says whether it would have. */
    public boolean removeShutdownHook(Thread hook) {
        return Shutdown.remove(hook);
    }
}
