package lejos.nxt;

import lejos.robotics.DCMotor;

/** A motor without regulation: the same power gives less speed with more load. */
public abstract class BasicMotor implements DCMotor {
    /** What no motor does. */
    protected static final int INVALID_MODE = -1;

    /** The port of the motor. */
    protected BasicMotorPort port;

    /** What the motor does: 1 forward, 2 backward, 3 brake, 4 roll. */
    protected int mode = BasicMotorPort.FLOAT;

    /** The power, 0 to 100. */
    protected int power;

    /** Makes one. */
    public BasicMotor() {
    }

    /** Sets the power at once, 0 to 100; with a minus, forward turns backward. */
    public void setPower(int power) {
        this.power = power;
        port.controlMotor(power, mode);
    }

    /** Gives the power. */
    public int getPower() {
        return power;
    }

    /** Turns the motor forward until it is told otherwise. */
    public void forward() {
        updateState(BasicMotorPort.FORWARD);
    }

    /** Turns the motor backward until it is told otherwise. */
    public void backward() {
        updateState(BasicMotorPort.BACKWARD);
    }

    /** Brakes the motor. */
    public void stop() {
        updateState(BasicMotorPort.STOP);
    }

    /** Lets the motor roll on without power. */
    public void flt() {
        updateState(BasicMotorPort.FLOAT);
    }

    /** Says whether the last command was forward or backward. */
    public boolean isMoving() {
        return mode < BasicMotorPort.STOP;
    }

    /** Lets the motor do something else: 1 forward, 2 backward, 3 brake, 4 roll. */
    protected void updateState(int mode) {
        this.mode = mode;
        port.controlMotor(power, mode);
    }
}
