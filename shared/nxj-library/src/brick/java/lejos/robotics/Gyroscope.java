package lejos.robotics;

/** Measures how fast the robot turns. */
public interface Gyroscope {
    /** Gives how fast the robot turns, in degrees a second. */
    float getAngularVelocity();

    /** Takes it that the robot does not turn now. */
    void recalibrateOffset();
}
