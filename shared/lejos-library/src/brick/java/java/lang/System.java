package java.lang;

/** The brick as a whole: its clock and its end. */
public final class System {
    private System() {
    }

    /** Ends the program at once; all motors stop. */
    public static native void exit(int code);

    /** Gives the milliseconds since the brick was switched on. */
    public static native long currentTimeMillis();

    /** Gives what knows about the brick's memory. */
    public static Runtime getRuntime() {
        return Runtime.ONLY;
    }

    static void arraycopy(char[] source, int from, char[] target, int to, int count) {
        for (int index = 0; index < count; index++) target[to + index] = source[from + index];
    }
}
