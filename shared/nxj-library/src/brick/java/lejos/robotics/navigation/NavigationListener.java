package lejos.robotics.navigation;

/** Is told how far a Navigator is. */
public interface NavigationListener {
    /** The robot has reached a point: where it is really, and the number of the point. */
    void atWaypoint(Waypoint waypoint, Pose pose, int sequence);

    /** The robot has reached the last point. */
    void pathComplete(Waypoint waypoint, Pose pose, int sequence);

    /** The robot was stopped on its way to a point. */
    void pathInterrupted(Waypoint waypoint, Pose pose, int sequence);
}
