package lejos.robotics;

/** Measures by how much it gets faster, in three directions. */
public interface Accelerometer {
    /** Gives the acceleration ahead; the unit is that of the sensor. */
    int getXAccel();

    /** Gives the acceleration to the left. */
    int getYAccel();

    /** Gives the acceleration upwards; a sensor that stands still measures gravity. */
    int getZAccel();
}
