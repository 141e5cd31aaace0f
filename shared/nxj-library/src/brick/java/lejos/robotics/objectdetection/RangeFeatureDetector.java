package lejos.robotics.objectdetection;

import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;

/** Looks for things that are nearer than a distance. */
public class RangeFeatureDetector extends FeatureDetectorAdapter {
    private final RangeFinder rangeFinder;
    private final float angle;
    private float maxDistance;

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

    /** Looks now, and gives what it finds, or null. */
    public Feature scan() {
        if (rangeFinder == null) return null;
        float[] ranges = rangeFinder.getRanges();
        RangeReadings readings = new RangeReadings(0);
        for (int index = 0; index < ranges.length; index++) {
            if (ranges[index] > 0 && ranges[index] < maxDistance) readings.add(new RangeReading(angle, ranges[index]));
        }
        return readings.isEmpty() ? null : new RangeFeature(readings);
    }
}
