package lejos.nxt;

/** The machine in the brick that runs the program; programs need it rarely. */
public class VM {
    private VM() {
    }

    /** Gives the methods that a thread is in: for each, its number times 65536 and the place in it. */
    public static native int[] createStackTrace(Thread thread, Object thrown);

    /** Lets a thread stand still, or for null all others. */
    public static native void suspendThread(Object thread);

    /** Lets a thread go on that stands still, or for null all others. */
    public static native void resumeThread(Object thread);
}
