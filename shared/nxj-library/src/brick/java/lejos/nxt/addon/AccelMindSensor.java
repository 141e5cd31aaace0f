package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.Accelerometer;

/** The acceleration and tilt sensor of mindsensors: 1000 are as much as a falling thing gets faster. */
public class AccelMindSensor extends I2CSensor implements Accelerometer {
    /** What the methods give if no sensor answers. */
    public static final int ERROR = Integer.MIN_VALUE;

    private static final int REG_TILT = 0x42;
    private static final int REG_ACCELERATION = 0x45;
    private static final int LEVEL = 128;
    private static final int AXES = 3;

    private final byte[] bytes = new byte[2 * AXES];

    /** Makes the sensor of a port. */
    public AccelMindSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Makes the sensor of a port, which has another address. */
    public AccelMindSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED_9V);
    }

    /** Gives by how many degrees its front is tilted up; ERROR if no sensor answers. */
    public int getXTilt() {
        return readTilt(0);
    }

    /** Gives by how many degrees its left is tilted up; ERROR if no sensor answers. */
    public int getYTilt() {
        return readTilt(1);
    }

    /** Gives by how many degrees its top looks up, 90 if it is level; ERROR if no sensor answers. */
    public int getZTilt() {
        return readTilt(2);
    }

    /** Gives the acceleration to where the sensor looks; ERROR if none answers. */
    public int getXAccel() {
        return readAcceleration(0);
    }

    /** Gives the acceleration to the left of where the sensor looks; ERROR if none answers. */
    public int getYAccel() {
        return readAcceleration(1);
    }

    /** Gives the acceleration upwards, about 1000 by gravity; ERROR if no sensor answers. */
    public int getZAccel() {
        return readAcceleration(2);
    }

    /** Puts all three tilts into the array, from a place on; says whether a sensor answers. */
    public boolean getAllTilt(int[] dst, int off) {
        if (getData(REG_TILT, bytes, 0, AXES) != 0) return false;
        for (int axis = 0; axis < AXES; axis++) dst[off + axis] = (bytes[axis] & 0xFF) - LEVEL;
        return true;
    }

    /** Puts all three accelerations into the array, from a place on; says whether a sensor answers. */
    public boolean getAllAccel(int[] dst, int off) {
        if (getData(REG_ACCELERATION, bytes, 0, 2 * AXES) != 0) return false;
        for (int axis = 0; axis < AXES; axis++) dst[off + axis] = joined(2 * axis);
        return true;
    }

    private int readTilt(int axis) {
        return getData(REG_TILT + axis, bytes, 1) != 0 ? ERROR : (bytes[0] & 0xFF) - LEVEL;
    }

    private int readAcceleration(int axis) {
        return getData(REG_ACCELERATION + 2 * axis, bytes, 2) != 0 ? ERROR : joined(0);
    }

    private int joined(int place) {
        return bytes[place] & 0xFF | bytes[place + 1] << 8;
    }
}
