package lejos.robotics.objectdetection;

import lejos.robotics.RangeReading;
import lejos.robotics.Touch;

/** Looks whether something touches a sensor. */
public class TouchFeatureDetector extends FeatureDetectorAdapter {
    private static final int DELAY = 50;

    private final Touch touch;
    private final float range;
    private final float angle;

    /** Makes one of a sensor in the middle of the robot. */
    public TouchFeatureDetector(Touch touchSensor) {
        this(touchSensor, 0, 0);
    }

    /** Makes one of a sensor that is so far to the right of the robot's middle, and so far before it. */
    public TouchFeatureDetector(Touch touchSensor, double xOffset, double yOffset) {
        super(DELAY);
        touch = touchSensor;
        range = (float) Math.sqrt(xOffset * xOffset + yOffset * yOffset);
        angle = range == 0 ? 0 : (float) Math.toDegrees(Math.atan2(-xOffset, yOffset));
    }

    /** Looks now, and gives what it finds, or null. */
    public Feature scan() {
        if (touch == null || !touch.isPressed()) return null;
        return new RangeFeature(new RangeReading(angle, range));
    }
}
