package lejos.nxt;

/** Something that the brick itself looks for every few milliseconds, so that a thread can wait for it. */
public class NXTEvent {
    /** Waits as long as it takes. */
    public static final int WAIT_FOREVER = -1;

    /** A sensor measures something else. */
    public static final int ANALOG_PORTS = 4;

    /** A button is pressed or released. */
    public static final int BUTTONS = 6;

    /** The brick wants something. */
    public static final int SYSTEM = 7;

    /**
     * Of SYSTEM: the program is to end.
     *
     * @hidden
     */
    public static final int SYSTEM_SHUTDOWN = 1;

    // The virtual machine reads the first four of these fields, adds to the fifth what has happened, and then does what
    // notifyAll of the first one does.
    private Object monitor;
    private int type;
    private int filter;
    private int period;
    private int happened;

    private NXTEvent(int type, int filter, int period) {
        this.type = type;
        this.filter = filter;
        this.period = period;
        monitor = this;
    }

    /** Makes one of a type that looks for some of its bits, every so many milliseconds, until free is called. */
    public static NXTEvent allocate(int type, int filter, int period) {
        NXTEvent event = new NXTEvent(type, filter, period);
        return event.registerEvent() < 0 ? null : event;
    }

    /** Gives the brick back what it needs for looking. */
    public void free() {
        unregisterEvent();
    }

    /** Waits at most so many milliseconds, and gives what has happened, or 0. */
    public int waitEvent(long timeout) {
        synchronized (monitor) {
            long end = System.currentTimeMillis() + timeout;
            try {
                while (happened == 0) {
                    if (timeout == WAIT_FOREVER) {
                        monitor.wait();
                    } else {
                        long rest = end - System.currentTimeMillis();
                        if (rest <= 0) break;
                        monitor.wait(rest);
                    }
                }
            } catch (InterruptedException wakened) {
                Thread.currentThread().interrupt();
            }
            return takeHappened();
        }
    }

    static NXTEvent allocate(int type, int filter, int period, Object monitor) {
        NXTEvent event = new NXTEvent(type, filter, period);
        event.monitor = monitor;
        event.registerEvent();
        return event;
    }

    boolean hasHappened() {
        return happened != 0;
    }

    int takeHappened() {
        synchronized (monitor) {
            int taken = happened;
            happened = 0;
            return taken;
        }
    }

    private native int registerEvent();

    private native int unregisterEvent();
}
