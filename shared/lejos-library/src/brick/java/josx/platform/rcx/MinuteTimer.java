package josx.platform.rcx;

/** The brick's own counter of minutes. */
public class MinuteTimer {
    /** Makes an object, of which nobody has a use: call the methods on the class. */
    public MinuteTimer() {
    }

    /** Lets the counter begin again. */
    public static void reset() {
        ROM.call((short) 0x339a, (short) 0);
    }
}
