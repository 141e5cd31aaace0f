package lejos.robotics.navigation;

/** Drives a robot straight on and in circles. */
public interface ArcMoveController extends MoveController {
    /** Gives the radius of the smallest circle that the robot can drive. */
    double getMinRadius();

    /** Sets the radius of the smallest circle that the robot can drive. */
    void setMinRadius(double radius);

    /** Drives forward in a circle, with its centre on the left if there is no minus. */
    void arcForward(double radius);

    /** Drives backward in a circle, with its centre on the left if there is no minus. */
    void arcBackward(double radius);

    /** Drives in a circle until the robot has turned by so many degrees, and waits until that is done. */
    void arc(double radius, double angle);

    /** Drives in a circle until the robot has turned by so many degrees, and says whether to go on at once. */
    void arc(double radius, double angle, boolean immediateReturn);

    /** Drives so far in a circle, and waits until the robot is there. */
    void travelArc(double radius, double distance);

    /** Drives so far in a circle, and says whether to go on at once. */
    void travelArc(double radius, double distance, boolean immediateReturn);
}
