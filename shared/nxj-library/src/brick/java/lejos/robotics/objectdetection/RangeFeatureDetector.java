package lejos.robotics.objectdetection;

import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;
import lejos.robotics.localization.PoseProvider;

/** Looks for things that are nearer than a distance. */
public class RangeFeatureDetector extends FeatureDetectorAdapter {
    private final RangeFinder rangeFinder;
    private final float angle;
    private float maxDistance;
    private PoseProvider poseProvider;

    /** Makes one of a sensor, the distance, and the milliseconds from one look to the next. */
    public RangeFeatureDetector(RangeFinder rf, float maxDistance, int delay) {
        this(rf, maxDistance, delay, 0);
    }

    /** Makes one whose sensor looks in a direction in degrees. */
    public RangeFeatureDetector(RangeFinder rf, float maxDistance, int delay, double angle) {
        super(delay);
        rangeFinder = rf;
        this.angle = (float) angle;
        this.maxDistance = maxDistance;
    }

    /** Gives the distance. */
    public float getMaxDistance() {
        return maxDistance;
    }

    /** Sets the distance. */
    public void setMaxDistance(float distance) {
        maxDistance = distance;
    }

    /** Sets what knows where the robot is, so that what it finds can tell. */
    public void setPoseProvider(PoseProvider pp) {
        poseProvider = pp;
    }

    /** Looks now; if the nearest thing is nearer than the distance, gives all that the sensor finds, otherwise null. */
    public Feature scan() {
        // The thread of the superclass may look before the constructor has set the sensor.
        if (rangeFinder == null) return null;
        float[] ranges = rangeFinder.getRanges();
        if (ranges.length == 0 || ranges[0] <= 0 || ranges[0] >= maxDistance) return null;
        RangeReadings readings = new RangeReadings(0);
        for (float range : ranges) readings.add(new RangeReading(angle, range));
        return poseProvider == null ? new RangeFeature(readings) : new RangeFeature(readings, poseProvider.getPose());
    }
}
