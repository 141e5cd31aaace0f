package lejos.robotics.navigation;

/** Drives a robot straight on. */
public interface MoveController extends MoveProvider {
    /** The diameter, in centimetres, of the wheels of the first NXT kit. */
    double WHEEL_SIZE_NXT1 = 5.60;

    /** The diameter, in centimetres, of the wheels of the second NXT kit. */
    double WHEEL_SIZE_NXT2 = 4.32;

    /** The diameter, in centimetres, of the large wheels of the RCX kit. */
    double WHEEL_SIZE_RCX = 8.16;

    /** Drives forward until the robot is told otherwise. */
    void forward();

    /** Drives backward until the robot is told otherwise. */
    void backward();

    /** Stops. */
    void stop();

    /** Says whether the robot moves. */
    boolean isMoving();

    /** Drives so far, backward if there is a minus, and waits until the robot is there. */
    void travel(double distance);

    /** Drives so far, and says whether to go on at once. */
    void travel(double distance, boolean immediateReturn);

    /** Sets how far the robot drives in a second. */
    void setTravelSpeed(double speed);

    /** Gives how far the robot drives in a second. */
    double getTravelSpeed();

    /** Gives how far the robot can drive in a second. */
    double getMaxTravelSpeed();
}
