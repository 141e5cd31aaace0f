package java.lang;

/** Knows how full the brick's memory is. */
public class Runtime {
    static final Runtime ONLY = new Runtime();

    private Runtime() {
    }

    /** Gives the only object of this class. */
    public static Runtime getRuntime() {
        return ONLY;
    }

    /** Gives the bytes of memory that are still free; on a brick they only become fewer. */
    public native long freeMemory();

    /** Gives the bytes of memory that a program has for its objects. */
    public native long totalMemory();
}
