package josx.platform.rcx;

/** Waits for something to happen: a sensor, a button or infrared light. */
public class Poll {
    /** Sensor 1 has changed. */
    public static final short SENSOR1_MASK = 0x01;

    /** Sensor 2 has changed. */
    public static final short SENSOR2_MASK = 0x02;

    /** Sensor 3 has changed. */
    public static final short SENSOR3_MASK = 0x04;

    /** Any sensor has changed. */
    public static final short ALL_SENSORS = 0x07;

    /** Run was pressed or released. */
    public static final short RUN_MASK = 0x08;

    /** View was pressed or released. */
    public static final short VIEW_MASK = 0x10;

    /** Prgm was pressed or released. */
    public static final short PRGM_MASK = 0x20;

    /** Any button was pressed or released. */
    public static final short ALL_BUTTONS = 0x38;

    /** How far a button's number is moved to the left in a mask. */
    public static final short BUTTON_MASK_SHIFT = 3;

    /** A packet of infrared light has come. */
    public static final short SERIAL_MASK = 0x40;

    /** Which bit of a mask stands for infrared light. */
    public static final short SERIAL_SHIFT = 6;

    // The virtual machine adds what has happened to this object's `changed` and wakes who waits for it.
    private static final Poll shared = new Poll(true);

    private short changed;

    /** Makes one. */
    public Poll() {
    }

    private Poll(boolean isShared) {
        setPoller();
    }

    /**
     * Waits until something of the mask happens and says what it was, 0 if the time in milliseconds was over before; 0 of them are forever.
     *
     * <p>What happened is told only once: if two wait for the same, one of them never hears of it.
     */
    public final int poll(int mask, int milliseconds) throws InterruptedException {
        synchronized (shared) {
            int news = shared.changed & mask;
            int end = (int) System.currentTimeMillis() + milliseconds;
            int rest = milliseconds;
            while (news == 0 && rest >= 0) {
                shared.wait(rest);
                news = shared.changed & mask;
                if (milliseconds != 0) {
                    rest = end - (int) System.currentTimeMillis();
                    if (rest == 0) rest = -1;
                }
            }
            shared.changed &= ~news;
            return news;
        }
    }

    /** Sets how many times the sensors are read before the brick looks for changes; 1 if nobody sets it. */
    public final void setThrottle(int readings) {
        Throttle.setThrottle(readings);
    }

    private native void setPoller();
}
