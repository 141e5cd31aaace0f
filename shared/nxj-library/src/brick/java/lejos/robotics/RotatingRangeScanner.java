package lejos.robotics;

import lejos.util.Delay;

/** Looks around by a motor that turns the sensor. */
public class RotatingRangeScanner implements RangeScanner {
    /** The sensor. */
    protected RangeFinder rangeFinder;

    /** The motor that turns it. */
    protected RegulatedMotor head;

    /** The directions in degrees. */
    protected float[] angles;

    private final float gearRatio;

    /** Makes one of a motor, which looks ahead now, and the sensor on it. */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder) {
        this(head, rangeFinder, 1f);
    }

    /**
     * Makes one whose motor turns so many degrees for one of the sensor.
     *
     * @hidden
     */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder, float gearRatio) {
        this.head = head;
        this.rangeFinder = rangeFinder;
        this.gearRatio = gearRatio;
    }

    /** Sets the directions, in degrees, counted to the left. */
    public void setAngles(float[] angles) {
        this.angles = angles.clone();
    }

    /** Looks in all directions, one after the other, and ahead again. */
    public RangeReadings getRangeValues() {
        if (angles == null) setAngles(new float[] {0f, 90f});
        RangeReadings readings = new RangeReadings(angles.length);
        for (int index = 0; index < angles.length; index++) {
            head.rotateTo(Math.round(angles[index] * gearRatio));
            Delay.msDelay(50);
            float range = rangeFinder.getRange();
            readings.setRange(index, angles[index], range >= 255f ? -1f : range);
        }
        head.rotateTo(0);
        return readings;
    }

    /** Gives the sensor. */
    public RangeFinder getRangeFinder() {
        return rangeFinder;
    }
}
