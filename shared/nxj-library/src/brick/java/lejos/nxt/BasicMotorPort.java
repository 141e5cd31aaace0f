package lejos.nxt;

/** A port for a motor: what every such port can do. */
public interface BasicMotorPort {
    /** In the pauses between its pulses, the motor rolls. */
    int PWM_FLOAT = 0;

    /** In the pauses between its pulses, the motor brakes. */
    int PWM_BRAKE = 1;

    /** The mode of controlMotor in which the motor turns forward. */
    int FORWARD = 1;

    /** The mode of controlMotor in which the motor turns backward. */
    int BACKWARD = 2;

    /** The mode of controlMotor in which the motor brakes. */
    int STOP = 3;

    /** The mode of controlMotor in which the motor rolls without power. */
    int FLOAT = 4;

    /** The highest power. */
    int MAX_POWER = 100;

    /** Sets the power, 0 to 100, and what the motor does: FORWARD, BACKWARD, STOP or FLOAT. */
    void controlMotor(int power, int mode);

    /** Sets what the motor does between its pulses: PWM_FLOAT or PWM_BRAKE. */
    void setPWMMode(int mode);
}
