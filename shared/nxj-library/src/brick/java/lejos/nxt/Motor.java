package lejos.nxt;

/** The three motors: Motor.A, Motor.B and Motor.C. */
public class Motor {
    /** The motor on port A. */
    public static final NXTRegulatedMotor A = new NXTRegulatedMotor(MotorPort.A);

    /** The motor on port B. */
    public static final NXTRegulatedMotor B = new NXTRegulatedMotor(MotorPort.B);

    /** The motor on port C. */
    public static final NXTRegulatedMotor C = new NXTRegulatedMotor(MotorPort.C);

    private Motor() {
    }

    /** Gives the motor with a number, 0 for A to 2 for C. */
    public static NXTRegulatedMotor getInstance(int id) {
        if (id < 0 || id > 2) throw new IllegalArgumentException();
        return id == 0 ? A : id == 1 ? B : C;
    }
}
