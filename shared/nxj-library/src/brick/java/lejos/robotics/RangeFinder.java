package lejos.robotics;

/** Measures how far away things are. */
public interface RangeFinder {
    /** Gives how far away the nearest thing is. */
    float getRange();

    /** Gives how far away several things are. */
    float[] getRanges();
}
