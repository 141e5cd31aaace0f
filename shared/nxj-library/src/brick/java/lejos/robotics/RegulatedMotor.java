package lejos.robotics;

/** A motor that keeps its speed and finds its place. */
public interface RegulatedMotor extends BaseMotor, Tachometer {
    /** Tells a listener when the motor begins to move and when it stops. */
    void addListener(RegulatedMotorListener listener);

    /** Tells the listener no more, and gives it, or null. */
    RegulatedMotorListener removeListener();

    /** Stops the motor, and says whether to go on at once. */
    void stop(boolean immediateReturn);

    /** Lets the motor roll, and says whether to go on at once. */
    void flt(boolean immediateReturn);

    /** Waits until the motor stands where it should, or cannot go on. */
    void waitComplete();

    /** Turns the motor by so many degrees, and says whether to go on at once. */
    void rotate(int angle, boolean immediateReturn);

    /** Turns the motor by so many degrees, and waits until it is there. */
    void rotate(int angle);

    /** Turns the motor until it has so many degrees, and waits until it is there. */
    void rotateTo(int limitAngle);

    /** Turns the motor until it has so many degrees, and says whether to go on at once. */
    void rotateTo(int limitAngle, boolean immediateReturn);

    /** Gives the degrees where the move ends. */
    int getLimitAngle();

    /** Sets the speed in degrees a second. */
    void setSpeed(int speed);

    /** Gives the speed that was set, in degrees a second. */
    int getSpeed();

    /** Gives the speed that the battery allows, in degrees a second. */
    float getMaxSpeed();

    /** Says whether something has kept the motor from moving on. */
    boolean isStalled();

    /** Sets when the motor gives up: so many degrees behind, for so many milliseconds. */
    void setStallThreshold(int error, int time);

    /** Sets how much faster the motor gets in a second, in degrees a second. */
    void setAcceleration(int acceleration);

    /**
     * Gives how much faster the motor gets in a second, in degrees a second.
     *
     * @hidden
     */
    int getAcceleration();
}
