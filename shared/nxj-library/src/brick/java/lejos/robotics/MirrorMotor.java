package lejos.robotics;

/** A motor turned round: forward is backward. */
public class MirrorMotor implements RegulatedMotor, RegulatedMotorListener {
    private final RegulatedMotor motor;
    private RegulatedMotorListener listener;

    private MirrorMotor(RegulatedMotor motor) {
        this.motor = motor;
        listener = motor.removeListener();
        motor.addListener(this);
    }

    /** Gives the motor turned round. */
    public static RegulatedMotor invertMotor(RegulatedMotor motor) {
        if (!(motor instanceof MirrorMotor)) return new MirrorMotor(motor);
        MirrorMotor mirror = (MirrorMotor) motor;
        mirror.motor.addListener(mirror.listener);
        return mirror.motor;
    }

    /** Gives a motor that is not regulated, such as an NXTMotor, turned round. */
    public static EncoderMotor invertMotor(EncoderMotor motor) {
        return motor instanceof ReversedEncoderMotor ? ((ReversedEncoderMotor) motor).motor
            : new ReversedEncoderMotor(motor);
    }

    /** Turns the motor backward. */
    public void forward() {
        motor.backward();
    }

    /** Turns the motor forward. */
    public void backward() {
        motor.forward();
    }

    /** Stops the motor, and waits until it stands. */
    public void stop() {
        motor.stop();
    }

    /** Stops the motor, and says whether to go on at once. */
    public void stop(boolean immediateReturn) {
        motor.stop(immediateReturn);
    }

    /** Lets the motor roll without power. */
    public void flt() {
        motor.flt();
    }

    /** Lets the motor roll without power, and says whether to go on at once. */
    public void flt(boolean immediateReturn) {
        motor.flt(immediateReturn);
    }

    /** Waits until the motor stands where it should, or cannot go on. */
    public void waitComplete() {
        motor.waitComplete();
    }

    /** Turns the motor by so many degrees the other way, and waits until it is there. */
    public void rotate(int angle) {
        motor.rotate(-angle);
    }

    /** Turns the motor by so many degrees the other way, and says whether to go on at once. */
    public void rotate(int angle, boolean immediateReturn) {
        motor.rotate(-angle, immediateReturn);
    }

    /** Turns the motor until it has so many degrees the other way, and waits until it is there. */
    public void rotateTo(int limitAngle) {
        motor.rotateTo(-limitAngle);
    }

    /** Turns the motor until it has so many degrees the other way, and says whether to go on at once. */
    public void rotateTo(int limitAngle, boolean immediateReturn) {
        motor.rotateTo(-limitAngle, immediateReturn);
    }

    /** Gives the degrees the other way where the move ends. */
    public int getLimitAngle() {
        return -motor.getLimitAngle();
    }

    /** Gives how many degrees the motor has turned the other way. */
    public int getTachoCount() {
        return -motor.getTachoCount();
    }

    /** Counts from 0. */
    public void resetTachoCount() {
        motor.resetTachoCount();
    }

    /** Gives how fast the motor turns the other way, in degrees a second. */
    public int getRotationSpeed() {
        return -motor.getRotationSpeed();
    }

    /** Sets the speed in degrees a second. */
    public void setSpeed(int speed) {
        motor.setSpeed(speed);
    }

    /** Gives the speed that was set, in degrees a second. */
    public int getSpeed() {
        return motor.getSpeed();
    }

    /** Gives the speed that the battery allows, in degrees a second. */
    public float getMaxSpeed() {
        return motor.getMaxSpeed();
    }

    /** Sets how much faster the motor gets in a second, in degrees a second. */
    public void setAcceleration(int acceleration) {
        motor.setAcceleration(acceleration);
    }

    /**
     * Gives how much faster the motor gets in a second, in degrees a second.
     *
     * @hidden
     */
    public int getAcceleration() {
        return motor.getAcceleration();
    }

    /** Says whether the motor is on its way. */
    public boolean isMoving() {
        return motor.isMoving();
    }

    /** Says whether something has kept the motor from moving on. */
    public boolean isStalled() {
        return motor.isStalled();
    }

    /** Sets when the motor gives up: so many degrees behind, for so many milliseconds. */
    public void setStallThreshold(int error, int time) {
        motor.setStallThreshold(error, time);
    }

    /** Tells a listener that the motor begins to move, when it does and, as in leJOS NXJ, also when it stops. */
    public void addListener(RegulatedMotorListener listener) {
        motor.addListener(this);
        this.listener = listener;
    }

    /** Tells the listener no more, and gives it, or null. */
    public RegulatedMotorListener removeListener() {
        RegulatedMotorListener old = listener;
        listener = null;
        motor.removeListener();
        return old;
    }

    /** Is told by the motor; programs need not call it. */
    public void rotationStarted(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        if (listener != null) listener.rotationStarted(this, -tachoCount, stalled, timeStamp);
    }

    /** Is told by the motor; programs need not call it. */
    public void rotationStopped(RegulatedMotor motor, int tachoCount, boolean stalled, long timeStamp) {
        if (listener != null) listener.rotationStarted(this, -tachoCount, stalled, timeStamp);
    }
}
