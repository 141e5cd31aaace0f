package lejos.nxt;

/** The machine in the brick that runs the program; programs need it rarely. */
public class VM {
    private VM() {
    }

    /** Gives the methods that a thread is in: for each, its number times 65536 and the place in it. */
    public static native int[] createStackTrace(Thread thread, Object thrown);

    /** Stops everything, shows an exception until ESCAPE is pressed, and ends the program. */
    public static native void firmwareExceptionHandler(Throwable thrown, int method, int offset);
}
