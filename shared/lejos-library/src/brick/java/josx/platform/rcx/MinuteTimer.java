package josx.platform.rcx;

/** The brick's own counter of minutes. */
public class MinuteTimer {
    private MinuteTimer() {
    }

    /** Lets the counter begin again. */
    public static void reset() {
        ROM.call((short) 0x339a, (short) 0);
    }
}
