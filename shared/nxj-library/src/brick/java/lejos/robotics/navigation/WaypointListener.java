package lejos.robotics.navigation;

/** Is told of new points. */
public interface WaypointListener {
    /** There is a further point. */
    void addWaypoint(Waypoint wp);

    /** There are no further points. */
    void pathGenerated();
}
