package lejos.robotics.objectdetection;

import lejos.robotics.RangeReading;
import lejos.robotics.RangeReadings;

/** A thing, or several, and how far away they are. */
public class RangeFeature implements Feature {
    private final RangeReadings readings;
    private final RangeReading reading;
    private final long timeStamp = System.currentTimeMillis();

    /** Makes one of a thing. */
    public RangeFeature(RangeReading rr) {
        reading = rr;
        readings = new RangeReadings(0);
        readings.add(rr);
    }

    /** Makes one of several things, the nearest first. */
    public RangeFeature(RangeReadings rrs) {
        readings = rrs;
        reading = rrs.get(0);
    }

    /** Gives the nearest thing. */
    public RangeReading getRangeReading() {
        return reading;
    }

    /** Gives all things. */
    public RangeReadings getRangeReadings() {
        return readings;
    }

    /** Gives when it was found. */
    public long getTimeStamp() {
        return timeStamp;
    }
}
