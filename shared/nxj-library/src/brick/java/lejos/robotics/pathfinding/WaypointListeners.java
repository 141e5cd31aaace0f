package lejos.robotics.pathfinding;

import java.util.ArrayList;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Who is told of the points of a way. */
class WaypointListeners {
    private final ArrayList<WaypointListener> listeners = new ArrayList<WaypointListener>();

    void add(WaypointListener listener) {
        listeners.add(listener);
    }

    void tell(Path path) {
        for (WaypointListener listener : listeners) {
            for (Waypoint waypoint : path) listener.addWaypoint(waypoint);
            listener.pathGenerated();
        }
    }
}
