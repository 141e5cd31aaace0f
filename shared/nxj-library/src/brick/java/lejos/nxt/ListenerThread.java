package lejos.nxt;

/** The thread in which all listeners to buttons and sensors are called. */
class ListenerThread extends Thread {
    private static final int CALLING_PRIORITY = NORM_PRIORITY;

    private static ListenerThread only;

    private NXTEvent[] events = new NXTEvent[0];
    private ListenerCaller[] callers = new ListenerCaller[0];

    private ListenerThread() {
        setPriority(MAX_PRIORITY);
        setDaemon(true);
    }

    /** Lets the thread call the listeners when such an event happens. */
    static synchronized void watch(ListenerCaller caller, int type, int filter, int period) {
        boolean isNew = only == null;
        if (isNew) only = new ListenerThread();
        only.add(caller, type, filter, period);
        if (isNew) only.start();
    }

    public void run() {
        while (true) {
            for (int index = 0; index < events.length; index++) {
                if (events[index].takeHappened() == 0) continue;
                setPriority(CALLING_PRIORITY);
                callers[index].callListeners();
                setPriority(MAX_PRIORITY);
            }
            await();
        }
    }

    private synchronized void add(ListenerCaller caller, int type, int filter, int period) {
        int count = events.length;
        NXTEvent[] moreEvents = new NXTEvent[count + 1];
        ListenerCaller[] moreCallers = new ListenerCaller[count + 1];
        System.arraycopy(events, 0, moreEvents, 0, count);
        System.arraycopy(callers, 0, moreCallers, 0, count);
        moreEvents[count] = NXTEvent.allocate(type, filter, period, this);
        moreCallers[count] = caller;
        callers = moreCallers;
        events = moreEvents;
    }

    private synchronized void await() {
        try {
            while (!hasHappened()) wait();
        } catch (InterruptedException lookAgain) {
            // Nobody has this thread to interrupt it.
        }
    }

    private boolean hasHappened() {
        for (int index = 0; index < events.length; index++) {
            if (events[index].hasHappened()) return true;
        }
        return false;
    }
}
