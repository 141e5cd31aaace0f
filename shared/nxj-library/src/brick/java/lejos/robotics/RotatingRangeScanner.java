package lejos.robotics;

import lejos.util.Delay;

/** Looks around by a motor that turns the sensor. */
public class RotatingRangeScanner implements RangeScanner {
    /** What is farther away counts as nothing. */
    protected final int MAX_RELIABLE_RANGE_READING = 180;

    /** How much is added to what the sensor measures. */
    protected final int ZERO = 2;

    /** What was measured. */
    protected RangeReadings readings;

    /** The sensor. */
    protected RangeFinder rangeFinder;

    /** The motor that turns it. */
    protected RegulatedMotor head;

    /** The directions in degrees; 0 and 90 to begin with. */
    protected float[] angles = {0, 90};

    /** How many degrees the motor turns for one of the sensor. */
    protected int gearRatio;

    /** The same with what is behind the point; 0 if it was given as a whole number. */
    private float exactRatio;

    /** Makes one of a motor, which looks ahead now, and the sensor on it. */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder) {
        this(head, rangeFinder, 1);
    }

    /** Makes one whose motor turns so many degrees for one of the sensor. */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder, int gearRatio) {
        this.head = head;
        this.rangeFinder = rangeFinder;
        this.gearRatio = gearRatio;
        head.resetTachoCount();
    }

    /**
     * Makes one whose motor turns so many degrees for one of the sensor, also parts of degrees.
     *
     * @hidden
     */
    public RotatingRangeScanner(RegulatedMotor head, RangeFinder rangeFinder, float gearRatio) {
        this(head, rangeFinder, (int) gearRatio);
        exactRatio = gearRatio;
    }

    /** Sets how many degrees the motor turns for one of the sensor. */
    public void setGearRatio(int gearRatio) {
        this.gearRatio = gearRatio;
        exactRatio = 0;
    }

    /** Sets the motor that turns the sensor. */
    public void setHeadMotor(RegulatedMotor motor) {
        head = motor;
    }

    /** Sets the directions, in degrees, counted to the left. */
    public void setAngles(float[] angles) {
        this.angles = angles.clone();
    }

    /** Looks in all directions, one after the other, and ahead again; -1 is for nothing within 180. */
    public RangeReadings getRangeValues() {
        if (readings == null || readings.getNumReadings() != angles.length) {
            readings = new RangeReadings(angles.length);
        }
        for (int i = 0; i < angles.length; i++) {
            int angle = (int) angles[i];
            head.rotateTo(exactRatio == 0 ? angle * gearRatio : (int) (angle * exactRatio));
            Delay.msDelay(50);
            float range = rangeFinder.getRange() + ZERO;
            readings.setRange(i, angles[i], range > MAX_RELIABLE_RANGE_READING ? -1 : range);
        }
        head.rotateTo(0);
        return readings;
    }

    /** Gives the sensor. */
    public RangeFinder getRangeFinder() {
        return rangeFinder;
    }
}
