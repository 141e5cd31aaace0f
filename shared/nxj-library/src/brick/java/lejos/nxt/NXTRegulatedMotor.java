package lejos.nxt;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * A motor that keeps its speed and finds its place, whatever the load is.
 *
 * <p>Every four milliseconds it looks where it is and where it should be, and sets the power.
 */
public class NXTRegulatedMotor implements RegulatedMotor {
    /** The limit of a move without one. */
    private static final int NO_LIMIT = 0x7FFFFFFF;

    private static final MotorRegulation regulation = new MotorRegulation();

    /** The port of the motor. */
    protected final TachoMotorPort tachoPort;

    private final MotorMove move;
    private float speed = 360;
    private int acceleration = 6000;
    private RegulatedMotorListener listener;

    /** Makes the motor of a port. */
    public NXTRegulatedMotor(TachoMotorPort port) {
        tachoPort = port;
        port.setPWMMode(BasicMotorPort.PWM_BRAKE);
        move = new MotorMove(this, port);
        regulation.add(move);
    }

    /** Turns the motor forward until it is told otherwise. */
    public void forward() {
        begin(speed, NO_LIMIT);
    }

    /** Turns the motor backward until it is told otherwise. */
    public void backward() {
        begin(speed, -NO_LIMIT);
    }

    /** Stops the motor, waits until it stands, and holds it there. */
    public void stop() {
        stop(false);
    }

    /** Stops the motor and holds it there, and says whether to go on at once. */
    public void stop(boolean immediateReturn) {
        synchronized (regulation) {
            if (!move.isHolding()) begin(0, NO_LIMIT);
        }
        if (!immediateReturn) waitComplete();
    }

    /** Lets the motor roll without power, and waits until it should stand. */
    public void flt() {
        flt(false);
    }

    /** Lets the motor roll without power, and says whether to go on at once. */
    public void flt(boolean immediateReturn) {
        synchronized (regulation) {
            move.roll();
            regulation.notifyAll();
        }
        if (!immediateReturn) waitComplete();
    }

    /** Turns the motor by so many degrees, backward if there is a minus, and waits until it is there. */
    public void rotate(int angle) {
        rotate(angle, false);
    }

    /** Turns the motor by so many degrees, and says whether to go on at once. */
    public void rotate(int angle, boolean immediateReturn) {
        synchronized (regulation) {
            begin(speed, move.getPosition() + angle);
        }
        if (!immediateReturn) waitComplete();
    }

    /** Turns the motor until it has so many degrees, and waits until it is there. */
    public void rotateTo(int limitAngle) {
        rotateTo(limitAngle, false);
    }

    /** Turns the motor until it has so many degrees, and says whether to go on at once. */
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        begin(speed, limitAngle);
        if (!immediateReturn) waitComplete();
    }

    /** Waits until the motor stands where it should, or cannot go on. */
    public void waitComplete() {
        boolean wasInterrupted = false;
        synchronized (regulation) {
            while (move.isMoving()) {
                try {
                    regulation.wait();
                } catch (InterruptedException goOnWaiting) {
                    wasInterrupted = true;
                }
            }
        }
        if (wasInterrupted) Thread.currentThread().interrupt();
    }

    /** Says whether the motor is on its way. */
    public boolean isMoving() {
        return move.isMoving();
    }

    /** Says whether something has kept the motor from moving on. */
    public boolean isStalled() {
        return move.isStalled();
    }

    /** Sets when the motor gives up: so many degrees behind, for so many milliseconds. */
    public void setStallThreshold(int error, int time) {
        synchronized (regulation) {
            move.setStallThreshold(error, time / MotorRegulation.PERIOD);
        }
    }

    /** Gives how many degrees the motor has turned since it was counted from 0. */
    public int getTachoCount() {
        return tachoPort.getTachoCount();
    }

    /** Stops the motor and counts from 0. */
    public void resetTachoCount() {
        if (isMoving()) stop();
        synchronized (regulation) {
            move.resetTachoCount();
        }
    }

    /** Gives the degrees where the motor should be now. */
    public int getPosition() {
        synchronized (regulation) {
            return move.getPosition();
        }
    }

    /** Sets the speed in degrees a second; 360 if nobody sets it. */
    public void setSpeed(int speed) {
        setSpeed((float) speed);
    }

    /** Sets the speed in degrees a second; 360 if nobody sets it. */
    public void setSpeed(float speed) {
        synchronized (regulation) {
            this.speed = Math.abs(speed);
            move.setSpeed(this.speed);
        }
    }

    /** Gives the speed that was set, in degrees a second. */
    public int getSpeed() {
        return Math.round(speed);
    }

    /** Gives the speed that the battery allows, in degrees a second. */
    public float getMaxSpeed() {
        return Battery.getVoltage() * 100f;
    }

    /** Sets how much faster the motor gets in a second, in degrees a second; 6000 if nobody sets it. */
    public void setAcceleration(int acceleration) {
        synchronized (regulation) {
            this.acceleration = Math.abs(acceleration);
            move.setAcceleration(this.acceleration);
        }
    }

    /** Gives the acceleration that was set. */
    public int getAcceleration() {
        return acceleration;
    }

    /** Gives how fast the motor should be now, in degrees a second. */
    public int getRotationSpeed() {
        synchronized (regulation) {
            return Math.round(move.getVelocity());
        }
    }

    /** Gives the degrees where the move ends. */
    public int getLimitAngle() {
        return move.getLimit();
    }

    /** Tells a listener when the motor begins to move and when it stops; there can be only one. */
    public void addListener(RegulatedMotorListener listener) {
        this.listener = listener;
    }

    /** Tells the listener no more, and gives it, or null. */
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener old = listener;
        listener = null;
        return old;
    }

    /** Lets the motor roll, and does not hold it any more; says whether it was held. */
    public boolean suspendRegulation() {
        synchronized (regulation) {
            return move.release();
        }
    }

    /**
     * Stops the motor and holds it.
     *
     * @deprecated the power does not matter any more: use stop.
     */
    @Deprecated
    public void lock(int power) {
        stop(false);
    }

    void tellStarted(int tachoCount) {
        RegulatedMotorListener told = listener;
        if (told != null) told.rotationStarted(this, tachoCount, false, System.currentTimeMillis());
    }

    void tellStopped(int tachoCount, boolean isStalled) {
        RegulatedMotorListener told = listener;
        if (told != null) told.rotationStopped(this, tachoCount, isStalled, System.currentTimeMillis());
    }

    private void begin(float speed, int limit) {
        boolean isNew;
        synchronized (regulation) {
            isNew = move.begin(speed, acceleration, limit);
            regulation.notifyAll();
        }
        if (isNew) tellStarted(getTachoCount());
    }
}
