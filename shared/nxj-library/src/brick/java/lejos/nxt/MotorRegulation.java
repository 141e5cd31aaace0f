package lejos.nxt;

/**
 * What the brick itself does for regulated motors: every four milliseconds it works out where each of them should be, and
 * sets its power.
 */
class MotorRegulation {
    /** The limit of a move without one; the same with a minus for a move backward. */
    static final int NO_LIMIT = 0x7FFFFFFF;

    /** The milliseconds from one look of the brick at its motors to the next, which begin with one divisible by it. */
    static final int PERIOD = 4;

    private MotorRegulation() {
    }

    /** Waits until the brick has looked at its motors again. */
    static void waitForLook() throws InterruptedException {
        Thread.sleep(PERIOD - (int) System.currentTimeMillis() % PERIOD);
    }

    static native void start(int port, float speed, int acceleration, int limit, boolean hold);

    static native void speed(int port, float speed);

    static native void acceleration(int port, int acceleration);

    static native void roll(int port);

    static native boolean suspend(int port);

    static native float position(int port);

    static native float velocity(int port);

    static native boolean isMoving(int port);

    static native boolean isStalled(int port);

    static native int limit(int port);

    static native void stallThreshold(int port, int error, int time);
}
