package lejos.nxt;

/** The thread that tells the listeners of motors when they stop; it rests while no motor with a listener moves. */
class MotorListeners extends Thread {
    private static MotorListeners only;

    private NXTRegulatedMotor[] motors = new NXTRegulatedMotor[0];

    private MotorListeners() {
        setPriority(MAX_PRIORITY);
        setDaemon(true);
    }

    /** Looks after a motor from now on. */
    static synchronized void watch(NXTRegulatedMotor motor) {
        boolean isNew = only == null;
        if (isNew) only = new MotorListeners();
        only.add(motor);
        if (isNew) only.start();
    }

    /** Says that a motor begins to move. */
    static void wake() {
        MotorListeners listeners = only;
        if (listeners == null) return;
        synchronized (listeners) {
            listeners.notify();
        }
    }

    /** Says whether this thread is the one that calls listeners. */
    static boolean isCurrent() {
        return only != null && Thread.currentThread() == only;
    }

    public void run() {
        while (true) {
            try {
                NXTRegulatedMotor[] watched = await();
                for (int index = 0; index < watched.length; index++) watched[index].tellIfStopped();
                MotorRegulation.waitForLook();
            } catch (InterruptedException lookAgain) {
                // Nobody has this thread to interrupt it.
            }
        }
    }

    private synchronized void add(NXTRegulatedMotor motor) {
        for (int index = 0; index < motors.length; index++) {
            if (motors[index] == motor) return;
        }
        NXTRegulatedMotor[] more = new NXTRegulatedMotor[motors.length + 1];
        System.arraycopy(motors, 0, more, 0, motors.length);
        more[motors.length] = motor;
        motors = more;
        notify();
    }

    private synchronized NXTRegulatedMotor[] await() throws InterruptedException {
        while (!isNeeded()) wait();
        return motors;
    }

    private boolean isNeeded() {
        for (int index = 0; index < motors.length; index++) {
            if (motors[index].hasToTell()) return true;
        }
        return false;
    }
}
