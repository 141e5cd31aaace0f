package lejos.nxt;

import lejos.robotics.Encoder;
import lejos.robotics.EncoderMotor;

/** A motor that gets as much power as the program says, and counts degrees. */
public class NXTMotor extends BasicMotor implements EncoderMotor {
    /** What counts the degrees. */
    protected Encoder encoderPort;

    /** Makes the motor of a port, with power 0. */
    public NXTMotor(TachoMotorPort port) {
        this(port, BasicMotorPort.PWM_BRAKE);
    }

    /** Makes the motor of a port, and says what it does between its pulses. */
    public NXTMotor(TachoMotorPort port, int pwmMode) {
        this.port = port;
        encoderPort = port;
        port.setPWMMode(pwmMode);
    }

    /** Gives how many degrees the motor has turned since it was counted from 0. */
    public int getTachoCount() {
        return encoderPort.getTachoCount();
    }

    /** Counts from 0. */
    public void resetTachoCount() {
        encoderPort.resetTachoCount();
    }
}
