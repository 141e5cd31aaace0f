package lejos.robotics.mapping;

import lejos.geom.Point;
import lejos.geom.Rectangle;
import lejos.robotics.navigation.Pose;

/** A map that tells how far away the next wall is. */
public interface RangeMap {
    /** Gives how far away the next wall is for a robot at a place that looks in a direction; below 0 for none. */
    float range(Pose pose);

    /** Tells whether a point is in the map. */
    boolean inside(Point p);

    /** Gives a rectangle around the map. */
    Rectangle getBoundingRect();
}
