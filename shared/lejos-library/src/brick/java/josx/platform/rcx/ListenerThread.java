package josx.platform.rcx;

/** Waits for all that listeners want to know and calls them, one after the other. */
class ListenerThread extends Thread {
    private static ListenerThread only;

    private final Poll poll = new Poll();
    private int mask;

    private ListenerThread() {
        setDaemon(true);
        setPriority(MAX_PRIORITY);
    }

    /** Looks from now on for this, too. */
    static void watch(int news) {
        synchronized (Memory.MONITOR) {
            if (only == null) only = new ListenerThread();
        }
        only.mask |= news;
        if (only.isAlive()) {
            only.interrupt();
        } else {
            only.start();
        }
    }

    /** Calls listeners for ever. */
    public void run() {
        while (true) {
            try {
                tell(poll.poll(mask, 0));
            } catch (InterruptedException thereIsMoreToWatch) {
                // The next poll has the new mask.
            }
        }
    }

    private static void tell(int news) {
        if ((news & Poll.SENSOR1_MASK) != 0) Sensor.S1.callListeners();
        if ((news & Poll.SENSOR2_MASK) != 0) Sensor.S2.callListeners();
        if ((news & Poll.SENSOR3_MASK) != 0) Sensor.S3.callListeners();
        if ((news & Poll.RUN_MASK) != 0) Button.RUN.callListeners();
        if ((news & Poll.VIEW_MASK) != 0) Button.VIEW.callListeners();
        if ((news & Poll.PRGM_MASK) != 0) Button.PRGM.callListeners();
        if ((news & Poll.SERIAL_MASK) != 0) Serial.callListeners();
    }
}
