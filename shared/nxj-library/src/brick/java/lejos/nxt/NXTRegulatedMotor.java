package lejos.nxt;

import lejos.robotics.RegulatedMotor;
import lejos.robotics.RegulatedMotorListener;

/**
 * A motor that keeps its speed and finds its place, whatever the load is.
 *
 * <p>Every four milliseconds the brick looks where the motor is and where it should be, and sets the power.
 */
public class NXTRegulatedMotor implements RegulatedMotor {
    /** The limit of a move that goes on until it is told otherwise. */
    protected static final int NO_LIMIT = MotorRegulation.NO_LIMIT;

    /** The port of the motor. */
    protected TachoMotorPort tachoPort;

    /** The speed of the next move, in degrees a second; it has no sign. */
    protected float speed = 360;

    /** The acceleration of the next move, in degrees a second each second. */
    protected int acceleration = 6000;

    /** Who is told when a move begins and ends; null for nobody. */
    protected RegulatedMotorListener listener;

    private final int port;

    /** Whether the motor is held or moves, so it is not free to roll. */
    private boolean isControlled;

    /** How many moves have begun, and the last one of whose end the listener knows. */
    private int begun;
    private int told;

    /** Makes the motor of a port. */
    public NXTRegulatedMotor(TachoMotorPort port) {
        if (!(port instanceof MotorPort)) throw new IllegalArgumentException();
        tachoPort = port;
        this.port = ((MotorPort) port).getId();
        port.setPWMMode(BasicMotorPort.PWM_BRAKE);
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
        if (!isControlled || MotorRegulation.isMoving(port)) begin(0, NO_LIMIT);
        if (!immediateReturn) waitComplete();
    }

    /** Lets the motor roll without power, and waits until it should stand. */
    public void flt() {
        flt(false);
    }

    /** Lets the motor roll without power, and says whether to go on at once. */
    public void flt(boolean immediateReturn) {
        isControlled = false;
        MotorRegulation.roll(port);
        if (!immediateReturn) waitComplete();
    }

    /** Turns the motor by so many degrees, backward if there is a minus, and waits until it is there. */
    public void rotate(int angle) {
        rotate(angle, false);
    }

    /** Turns the motor by so many degrees, and says whether to go on at once. */
    public void rotate(int angle, boolean immediateReturn) {
        begin(speed, getPosition() + angle);
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
        while (isMoving() || hasToTell() && !MotorListeners.isCurrent()) {
            try {
                MotorRegulation.waitForLook();
            } catch (InterruptedException goOnWaiting) {
                wasInterrupted = true;
            }
        }
        if (wasInterrupted) Thread.currentThread().interrupt();
    }

    /** Says whether the motor is on its way. */
    public boolean isMoving() {
        return MotorRegulation.isMoving(port);
    }

    /** Says whether something has kept the motor from moving on. */
    public boolean isStalled() {
        return MotorRegulation.isStalled(port);
    }

    /** Sets when the motor gives up: so many degrees behind, for so many milliseconds. */
    public void setStallThreshold(int error, int time) {
        MotorRegulation.stallThreshold(port, error, time);
    }

    /** Gives how many degrees the motor has turned since it was counted from 0. */
    public int getTachoCount() {
        return tachoPort.getTachoCount();
    }

    /** Stops the motor and counts from 0. */
    public void resetTachoCount() {
        if (isMoving()) stop();
        tachoPort.resetTachoCount();
    }

    /** Gives the degrees where the motor should be now. */
    public int getPosition() {
        return Math.round(MotorRegulation.position(port));
    }

    /** Sets the speed in degrees a second; 360 if nobody sets it. */
    public void setSpeed(int speed) {
        setSpeed((float) speed);
    }

    /** Sets the speed in degrees a second; 360 if nobody sets it. */
    public void setSpeed(float speed) {
        this.speed = Math.abs(speed);
        if (isMoving()) MotorRegulation.speed(port, this.speed);
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
        this.acceleration = Math.abs(acceleration);
        if (isMoving()) MotorRegulation.acceleration(port, this.acceleration);
    }

    /** Gives the acceleration that was set. */
    public int getAcceleration() {
        return acceleration;
    }

    /** Gives how fast the motor should be now, in degrees a second. */
    public int getRotationSpeed() {
        return Math.round(MotorRegulation.velocity(port));
    }

    /** Gives the degrees where the move ends. */
    public int getLimitAngle() {
        return MotorRegulation.limit(port);
    }

    /** Tells a listener when the motor begins to move and when it stops; there can be only one. */
    public void addListener(RegulatedMotorListener listener) {
        if (!isMoving()) told = begun;
        this.listener = listener;
        if (listener != null) MotorListeners.watch(this);
    }

    /** Tells the listener no more, and gives it, or null. */
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener old = listener;
        listener = null;
        return old;
    }

    /** Lets the motor roll, and does not hold it any more; says whether it was held. */
    public boolean suspendRegulation() {
        isControlled = false;
        return MotorRegulation.suspend(port);
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

    /** Says whether a move has begun of whose end the listener does not know. */
    boolean hasToTell() {
        return listener != null && told != begun;
    }

    /** Tells the listener if the motor has stopped. */
    void tellIfStopped() {
        if (!hasToTell() || isMoving()) return;
        int move = begun;
        RegulatedMotorListener listener = this.listener;
        if (listener != null) listener.rotationStopped(this, getTachoCount(), isStalled(), System.currentTimeMillis());
        // Only now, so that whoever waits goes on after the listener.
        told = move;
    }

    private void begin(float speed, int limit) {
        boolean isNew = !isMoving();
        isControlled = true;
        MotorRegulation.start(port, speed, acceleration, limit, true);
        begun++;
        RegulatedMotorListener listener = this.listener;
        if (listener == null) return;
        if (isNew) listener.rotationStarted(this, getTachoCount(), false, System.currentTimeMillis());
        MotorListeners.wake();
    }
}
