package lejos.nxt;

/** A sensor that measures how warm it is. */
public class TemperatureSensor extends I2CSensor {
    private static final int ADDRESS = 0x98;
    private static final int REG_TEMPERATURE = 0x00;
    private static final int REG_CONFIGURATION = 0x01;
    private static final byte FINEST = 0x60;

    /** Makes the sensor of a port. */
    public TemperatureSensor(I2CPort port) {
        super(port, ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
        sendData(REG_CONFIGURATION, FINEST);
    }

    /** Gives how warm it is, in degrees Celsius. */
    public float getTemperature() {
        byte[] bytes = new byte[2];
        if (getData(REG_TEMPERATURE, bytes, 2) < 0) return Float.NaN;
        return (bytes[0] << 8 | bytes[1] & 0xFF) / 256f;
    }
}
