package lejos.nxt.addon;

import lejos.nxt.BasicMotor;
import lejos.nxt.BasicMotorPort;

/** A motor without a counter, such as that of an RCX, on a port of the brick or of an RCX far away. */
public class RCXMotor extends BasicMotor {
    /** Makes the motor of a port, such as MotorPort.A. */
    public RCXMotor(BasicMotorPort port) {
        this.port = port;
    }
}
