package lejos.robotics.pathfinding;

import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Finds a way from one place to another, around what is in between. */
public interface PathFinder {
    /** Gives the points of the way. */
    Path findRoute(Pose start, Waypoint destination) throws DestinationUnreachableException;

    /** Adds a listener that is told of the points that startPathFinding finds. */
    void addListener(WaypointListener wpl);

    /** Looks for the way, and tells the listeners. */
    void startPathFinding(Pose start, Waypoint end);
}
