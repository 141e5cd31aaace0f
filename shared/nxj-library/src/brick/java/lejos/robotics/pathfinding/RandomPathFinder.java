package lejos.robotics.pathfinding;

import lejos.geom.Point;
import lejos.geom.Rectangle;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.mapping.RangeMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Finds a way by chance: short moves, from each of which the sensor can measure walls in some directions. */
public class RandomPathFinder implements PathFinder {
    private static final float LEAST_GAIN = 1;

    private final WaypointListeners listeners = new WaypointListeners();
    private final RangeMap map;
    private final RangeReadings readings;
    private float clearance = 20;
    private float maxRange = 150;
    private float maxDistance = 200;
    private int maxIterations = 1000;

    /** Makes one of a map, and of readings that say in which directions the sensor measures. */
    public RandomPathFinder(RangeMap map, RangeReadings readings) {
        this.map = map;
        this.readings = readings;
    }

    /** Sets how far the sensor measures; 150 to begin with. */
    public void setMaxRange(float range) {
        maxRange = range;
    }

    /** Sets how long a move is at most; 200 to begin with. */
    public void setMaxDistance(float distance) {
        maxDistance = distance;
    }

    /** Sets how many times it tries to find the next point; 1000 to begin with. */
    public void setMaxIterations(int iterations) {
        maxIterations = iterations;
    }

    /** Sets how far points are from the edge of the map; 20 to begin with. */
    public void setClearance(float clearance) {
        this.clearance = clearance;
    }

    /** Gives the points of the way; it turns the start towards the destination. */
    public Path findRoute(Pose start, Waypoint destination) throws DestinationUnreachableException {
        Pose pose = start;
        Path route = new Path();
        while (true) {
            pose.setHeading(pose.angleTo(destination));
            float rest = pose.distanceTo(destination);
            if (rest < maxDistance && map.range(pose) >= rest) {
                route.add(new Waypoint(destination));
                return route;
            }
            pose = next(pose, destination);
            route.add(new Waypoint(pose));
        }
    }

    private Pose next(Pose from, Waypoint destination) throws DestinationUnreachableException {
        for (int i = 0; i < maxIterations; i++) {
            Pose pose = anywhere();
            if (pose.distanceTo(from.getLocation()) > maxDistance) continue;
            if (from.distanceTo(destination) - pose.distanceTo(destination) < LEAST_GAIN) continue;
            float heading = pose.getHeading();
            if (!measures(pose, heading)) continue;
            pose.setHeading(pose.angleTo(from.getLocation()));
            if (map.range(pose) < pose.distanceTo(from.getLocation())) continue;
            pose.setHeading(heading);
            return pose;
        }
        throw new DestinationUnreachableException();
    }

    private boolean measures(Pose pose, float heading) {
        for (RangeReading reading : readings) {
            pose.setHeading(heading + reading.getAngle());
            if (map.range(pose) > maxRange) return false;
        }
        return true;
    }

    private Pose anywhere() {
        Rectangle around = map.getBoundingRect();
        while (true) {
            float x = around.x + clearance + (float) Math.random() * (around.width - clearance * 2);
            float y = around.y + clearance + (float) Math.random() * (around.height - clearance * 2);
            if (map.inside(new Point(x, y))) return new Pose(x, y, (float) Math.random() * 360);
        }
    }

    /** Adds a listener that is told of the points that startPathFinding finds. */
    public void addListener(WaypointListener wpl) {
        listeners.add(wpl);
    }

    /** Looks for the way, and tells the listeners if there is one. */
    public void startPathFinding(Pose start, Waypoint end) {
        try {
            listeners.tell(findRoute(start, end));
        } catch (DestinationUnreachableException unreachable) {
            // Nobody is told, as in leJOS NXJ.
        }
    }
}
