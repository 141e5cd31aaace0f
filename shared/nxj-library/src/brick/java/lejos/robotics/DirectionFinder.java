package lejos.robotics;

/** Knows where the robot looks. */
public interface DirectionFinder {
    /** Gives where the robot looks, in degrees, counted to the left. */
    float getDegreesCartesian();

    /** Counts from where the robot looks now. */
    void resetCartesianZero();

    /** Begins to get used to the place; turn the robot round then. */
    void startCalibration();

    /** Has got used to the place. */
    void stopCalibration();
}
