package lejos.robotics;

/** Looks around and measures how far away things are. */
public interface RangeScanner {
    /** Looks in all directions that were set. */
    RangeReadings getRangeValues();

    /** Sets the directions, in degrees, counted to the left. */
    void setAngles(float[] angles);

    /** Gives what measures. */
    RangeFinder getRangeFinder();
}
