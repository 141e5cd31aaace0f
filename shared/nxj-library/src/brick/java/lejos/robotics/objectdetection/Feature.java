package lejos.robotics.objectdetection;

import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;

/** Something that a FeatureDetector has found. */
public interface Feature {
    /** Gives the nearest thing. */
    RangeReading getRangeReading();

    /** Gives all things. */
    RangeReadings getRangeReadings();

    /** Gives when it was found. */
    long getTimeStamp();
}
