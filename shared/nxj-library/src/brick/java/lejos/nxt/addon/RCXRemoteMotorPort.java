package lejos.nxt.addon;

import lejos.nxt.BasicMotorPort;
import lejos.util.Delay;

/** A port for a motor of an RCX that an RCXLink tells what to do. */
public class RCXRemoteMotorPort implements BasicMotorPort {
    private static final int PAUSE = 50;
    private static final double PERCENT_OF_A_STEP = 12.5;
    private static final int HIGHEST_STEP = 7;

    private final RCXLink link;
    private final int id;
    private boolean isStarted;
    private int lastPower = -1;

    /** Makes the port with a number, 0 for A to 2 for C. */
    public RCXRemoteMotorPort(RCXLink link, int id) {
        this.link = link;
        this.id = id;
    }

    /** Sets the power, 0 to 100, and what the motor does: FORWARD, BACKWARD, STOP or FLOAT; takes up to 0.2 seconds. */
    public void controlMotor(int power, int mode) {
        boolean isToTurn = mode == FORWARD || mode == BACKWARD;
        boolean isToStart = isToTurn && !isStarted;
        if (isToStart) {
            link.startMotor(id);
            Delay.msDelay(PAUSE);
        }
        // As in leJOS NXJ, every second command starts the motor anew.
        isStarted = isToStart;
        if (power != lastPower) {
            link.setMotorPower(id, Math.min(HIGHEST_STEP, (int) (power / PERCENT_OF_A_STEP)));
            Delay.msDelay(PAUSE);
        }
        lastPower = power;
        if (mode == FORWARD) link.forward(id);
        else if (mode == BACKWARD) link.backward(id);
        else if (mode == STOP) link.stopMotor(id);
        else if (mode == FLOAT) link.fltMotor(id);
    }

    /** Does nothing: an RCX decides what its motors do between their pulses. */
    public void setPWMMode(int mode) {
    }
}
