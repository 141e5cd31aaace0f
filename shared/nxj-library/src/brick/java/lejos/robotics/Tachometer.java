package lejos.robotics;

/** Counts the degrees that a motor turns, and knows its speed. */
public interface Tachometer extends Encoder {
    /** Gives the speed in degrees a second. */
    int getRotationSpeed();
}
