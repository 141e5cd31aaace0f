package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.Accelerometer;

/** The acceleration sensor of HiTechnic: 200 are as much as a falling thing gets faster. */
public class AccelHTSensor extends I2CSensor implements Accelerometer {
    /** What the methods give if no sensor answers. */
    public static final int ERROR = Integer.MIN_VALUE;

    private static final int REG_ACCELERATION = 0x42;
    private static final int AXES = 3;

    private final byte[] bytes = new byte[2 * AXES];

    /** Makes the sensor of a port. */
    public AccelHTSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Makes the sensor of a port, which has another address. */
    public AccelHTSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED_9V);
    }

    /** Gives the acceleration to where the sensor looks; ERROR if none answers. */
    public int getXAccel() {
        return read(0);
    }

    /** Gives the acceleration to the left of where the sensor looks; ERROR if none answers. */
    public int getYAccel() {
        return read(1);
    }

    /** Gives the acceleration upwards, about 200 by gravity; ERROR if no sensor answers. */
    public int getZAccel() {
        return read(2);
    }

    /** Puts all three into the array, from a place on; says whether a sensor answers. */
    public boolean getAllAccel(int[] dst, int off) {
        if (getData(REG_ACCELERATION, bytes, 0, 2 * AXES) != 0) return false;
        for (int axis = 0; axis < AXES; axis++) dst[off + axis] = joined(axis);
        return true;
    }

    private int read(int axis) {
        return getData(REG_ACCELERATION + axis, bytes, 0, AXES + 1) != 0 ? ERROR : joined(0);
    }

    /** Eight bits and, three places behind them, the two lowest ones. */
    private int joined(int place) {
        return (bytes[place] << 2) + (bytes[place + AXES] & 0xFF);
    }
}
