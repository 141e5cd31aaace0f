package lejos.robotics;

import lejos.robotics.navigation.RotateMoveController;
import lejos.util.Delay;

/** Looks around by turning the robot, on which the sensor does not turn. */
public class FixedRangeScanner implements RangeScanner {
    /** The sensor. */
    protected RangeFinder rangeFinder;

    /** What turns the robot. */
    protected RotateMoveController pilot;

    /** The directions in degrees; set them first. */
    protected float[] angles;

    /** What is farther away counts as nothing. */
    protected final int MAX_RELIABLE_RANGE_READING = 180;

    /** How much is added to what the sensor measures. */
    protected final int ZERO = 2;

    /** What was measured. */
    protected RangeReadings readings;

    /** Makes one of a pilot and a sensor. */
    public FixedRangeScanner(RotateMoveController aPilot, RangeFinder rangeFinder) {
        pilot = aPilot;
        this.rangeFinder = rangeFinder;
    }

    /** Turns the robot in all directions, one after the other, and back; -1 is for nothing within 180. */
    public RangeReadings getRangeValues() {
        if (readings == null || readings.getNumReadings() != angles.length) {
            readings = new RangeReadings(angles.length);
        }
        float heading = 0;
        for (int i = 0; i < angles.length; i++) {
            turn(angles[i] - heading);
            heading = angles[i];
            Delay.msDelay(50);
            float range = rangeFinder.getRange() + ZERO;
            readings.setRange(i, angles[i], range > MAX_RELIABLE_RANGE_READING ? -1 : range);
        }
        turn(-angles[angles.length - 1]);
        return readings;
    }

    private void turn(float angle) {
        pilot.rotate(angle < -180 ? angle + 360 : angle > 180 ? angle - 360 : angle);
    }

    /** Sets the directions, in degrees, counted to the left. */
    public void setAngles(float[] angleSet) {
        angles = angleSet;
    }

    /** Gives the sensor. */
    public RangeFinder getRangeFinder() {
        return rangeFinder;
    }
}
