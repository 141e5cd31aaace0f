package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.DirectionFinder;

/** A compass of HiTechnic: it knows where north is. */
public class CompassHTSensor extends I2CSensor implements DirectionFinder {
    private static final int REG_MODE = 0x41;
    private static final int REG_HEADING = 0x42;
    private static final byte MEASURE = 0x00;
    private static final byte CALIBRATE = 0x43;

    private float zero;

    /** Makes the sensor of a port. */
    public CompassHTSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Makes the sensor of a port, which has another address. */
    public CompassHTSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
    }

    /** Gives where the robot looks, 0 to 360 degrees to the right of north; -1 if no sensor answers. */
    public float getDegrees() {
        byte[] bytes = new byte[2];
        if (getData(REG_HEADING, bytes, 2) != 0) return -1;
        return 2 * (bytes[0] & 0xFF) + bytes[1];
    }

    /** Gives where the robot looks, 0 to 360 degrees to the left of where resetCartesianZero was called. */
    public float getDegreesCartesian() {
        float degrees = zero - getDegrees();
        if (degrees >= 360) degrees -= 360;
        return degrees < 0 ? degrees + 360 : degrees;
    }

    /** Counts from where the robot looks now. */
    public void resetCartesianZero() {
        zero = getDegrees();
    }

    /** Begins to get used to the place; turn the robot round twice, slowly, then. */
    public void startCalibration() {
        sendData(REG_MODE, CALIBRATE);
    }

    /** Has got used to the place. */
    public void stopCalibration() {
        sendData(REG_MODE, MEASURE);
    }
}
