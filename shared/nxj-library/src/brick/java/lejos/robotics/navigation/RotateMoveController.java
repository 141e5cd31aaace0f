package lejos.robotics.navigation;

/** Drives a robot straight on, and turns it on the spot. */
public interface RotateMoveController extends MoveController {
    /** Turns by so many degrees, to the right if there is a minus, and waits until that is done. */
    void rotate(double angle);

    /** Turns by so many degrees, and says whether to go on at once. */
    void rotate(double angle, boolean immediateReturn);

    /** Sets how many degrees the robot turns in a second. */
    void setRotateSpeed(double speed);

    /** Gives how many degrees the robot turns in a second. */
    double getRotateSpeed();

    /** Gives how many degrees the robot can turn in a second. */
    double getRotateMaxSpeed();
}
