package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.DirectionFinder;

/** A compass of mindsensors: it knows where north is. */
public class CompassMindSensor extends I2CSensor implements DirectionFinder {
    private static final int REG_COMMAND = 0x41;
    private static final int REG_HEADING = 0x42;
    private static final byte BEGIN_CALIBRATION = 0x43;
    private static final byte END_CALIBRATION = 0x44;

    private final byte[] bytes = new byte[2];
    private float zero;

    /** Makes the sensor of a port. */
    public CompassMindSensor(I2CPort port) {
        this(port, DEFAULT_I2C_ADDRESS);
    }

    /** Makes the sensor of a port, which has another address. */
    public CompassMindSensor(I2CPort port, int address) {
        super(port, address, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
    }

    /** Gives where the robot looks, 0 to 360 degrees to the right of north, in steps of 1 or 2; -1 if no sensor answers. */
    public float getDegrees() {
        if (getData(REG_HEADING, bytes, 2) != 0) return -1;
        return (bytes[0] & 0xFF) * 360 / 255;
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
        sendData(REG_COMMAND, BEGIN_CALIBRATION);
    }

    /** Has got used to the place. */
    public void stopCalibration() {
        sendData(REG_COMMAND, END_CALIBRATION);
    }
}
