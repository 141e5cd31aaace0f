package lejos.robotics;

/** How far away a thing is in one direction. */
public class RangeReading {
    private final float angle;
    private final float range;

    /** Makes one of a direction in degrees and of how far away the thing is; below 0 for nothing. */
    public RangeReading(float angle, float range) {
        this.angle = angle;
        this.range = range;
    }

    /** Gives how far away the thing is, below 0 for nothing. */
    public float getRange() {
        return range;
    }

    /** Gives the direction in degrees, counted to the left from where the robot looks. */
    public float getAngle() {
        return angle;
    }

    /** Says whether there is nothing. */
    public boolean invalidReading() {
        return range < 0;
    }
}
