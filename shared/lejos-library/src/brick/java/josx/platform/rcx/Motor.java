package josx.platform.rcx;

/** One of the three motors: Motor.A, Motor.B and Motor.C. */
public class Motor {
    /** The motor on port A. */
    public static final Motor A = new Motor('A');

    /** The motor on port B. */
    public static final Motor B = new Motor('B');

    /** The motor on port C. */
    public static final Motor C = new Motor('C');

    private static final int FORWARD = 1;
    private static final int BACKWARD = 2;
    private static final int STOP = 3;
    private static final int FLOAT = 4;
    private static final int FULL_POWER = 7;

    private final char id;
    private int mode = FLOAT;
    private int power = 3;

    private Motor(char id) {
        this.id = id;
    }

    /** Gives the letter of the motor's port. */
    public final char getId() {
        return id;
    }

    /** Sets how strong the motor is, from 0 to 7; 0 is weak, not off. */
    public final void setPower(int power) {
        this.power = power;
        controlMotor(id, mode, power);
    }

    /** Gives how strong the motor is, from 0 to 7; 3 if nobody has changed it. */
    public final int getPower() {
        return power;
    }

    /** Turns the motor forward until it is told otherwise. */
    public final void forward() {
        run(FORWARD);
    }

    /** Turns the motor backward until it is told otherwise. */
    public final void backward() {
        run(BACKWARD);
    }

    /** Turns the other way around, if the motor turns at all. */
    public final void reverseDirection() {
        if (mode == FORWARD) {
            backward();
        } else if (mode == BACKWARD) {
            forward();
        }
    }

    /** Brakes the motor. */
    public final void stop() {
        mode = STOP;
        controlMotor(id, STOP, FULL_POWER);
    }

    /** Lets the motor roll on without power. */
    public final void flt() {
        run(FLOAT);
    }

    /** Says whether the last command was forward. */
    public final boolean isForward() {
        return mode == FORWARD;
    }

    /** Says whether the last command was backward. */
    public final boolean isBackward() {
        return mode == BACKWARD;
    }

    /** Says whether the last command was forward or backward. */
    public final boolean isMoving() {
        return mode < STOP;
    }

    /** Says whether the motor rolls without power. */
    public final boolean isFloating() {
        return mode == FLOAT;
    }

    /** Says whether the last command was stop. */
    public final boolean isStopped() {
        return mode == STOP;
    }

    /**
     * Tells the motor of a port directly what to do: 1 forward, 2 backward, 3 stop, 4 roll.
     *
     * @deprecated the motor's object does not notice.
     */
    public static void controlMotor(char id, int mode, int power) {
        ROM.call((short) 0x1a4e, (short) (0x2000 + id - 'A'), (short) mode, (short) power);
    }

    private void run(int mode) {
        this.mode = mode;
        controlMotor(id, mode, power);
    }
}
