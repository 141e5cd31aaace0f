package lejos.nxt;

/** One of the three ports for motors: MotorPort.A, MotorPort.B and MotorPort.C. */
public class MotorPort implements TachoMotorPort {
    /** How many ports for motors the brick has. */
    public static final int NUMBER_OF_PORTS = 3;

    /** The port A. */
    public static final MotorPort A = new MotorPort(0);

    /** The port B. */
    public static final MotorPort B = new MotorPort(1);

    /** The port C. */
    public static final MotorPort C = new MotorPort(2);

    private final int id;
    private int pwmMode = PWM_FLOAT;

    private MotorPort(int id) {
        this.id = id;
    }

    /** Gives the port with a number, 0 for A to 2 for C. */
    public static MotorPort getInstance(int id) {
        if (id < 0 || id >= NUMBER_OF_PORTS) throw new IllegalArgumentException();
        return id == 0 ? A : id == 1 ? B : C;
    }

    /** Gives the number of the port, 0 for A to 2 for C. */
    public final int getId() {
        return id;
    }

    /** Sets the power, 0 to 100, and what the motor does: 1 forward, 2 backward, 3 brake, 4 roll. */
    public void controlMotor(int power, int mode) {
        if (mode >= STOP) {
            controlMotorById(id, 0, mode == STOP ? 1 : 0);
        } else {
            controlMotorById(id, mode == FORWARD ? power : -power, pwmMode);
        }
    }

    /** Gives how many degrees the motor has turned since it was counted from 0. */
    public int getTachoCount() {
        return getTachoCountById(id);
    }

    /** Counts from 0. */
    public void resetTachoCount() {
        resetTachoCountById(id);
    }

    /** Sets what the motor does between its pulses: 0 roll, 1 brake. */
    public void setPWMMode(int mode) {
        pwmMode = mode;
    }

    static native void controlMotorById(int id, int power, int brake);

    static native int getTachoCountById(int id);

    static native void resetTachoCountById(int id);
}
