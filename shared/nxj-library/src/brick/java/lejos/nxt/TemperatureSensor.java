package lejos.nxt;

/** A sensor that measures how warm it is. */
public class TemperatureSensor extends I2CSensor {
    /** Measures in steps of half a degree. */
    public static final int RESOLUTION_9BIT = 0;

    /** Measures in steps of a quarter of a degree. */
    public static final int RESOLUTION_10BIT = 1;

    /** Measures in steps of an eighth of a degree. */
    public static final int RESOLUTION_11BIT = 2;

    /** Measures in steps of a sixteenth of a degree. */
    public static final int RESOLUTION_12BIT = 3;

    /** The address of the sensor. */
    protected static final int I2C_ADDRESS = 0x98;

    /** Where the temperature is. */
    protected static final int REG_TEMPERATURE = 0x00;

    /** Where the resolution is. */
    protected static final int REG_CONFIG = 0x01;

    /** Where the lower limit of an alarm is. */
    protected static final int REG_TLOW = 0x02;

    /** Where the upper limit of an alarm is. */
    protected static final int REG_THIGH = 0x03;

    private static final int FASTEST = 28;
    private static final int SECOND = 55;
    private static final int RESOLUTION_SHIFT = 5;

    private final byte[] bytes = new byte[2];

    /** Makes the sensor of a port. */
    public TemperatureSensor(I2CPort port) {
        super(port, I2C_ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED);
    }

    /** Gives how many milliseconds the sensor needs with a resolution, RESOLUTION_9BIT to RESOLUTION_12BIT. */
    public static int getSamplingDelay(int resolution) {
        check(resolution);
        return resolution == RESOLUTION_9BIT ? FASTEST : SECOND << resolution - RESOLUTION_10BIT;
    }

    /** Gives how warm it is, in degrees Celsius; in steps of half a degree if nobody has set the resolution. */
    public float getTemperature() {
        getData(REG_TEMPERATURE, bytes, 2);
        return (bytes[0] << 8 | bytes[1] & 0xFF) / 256f;
    }

    /** Gives in which steps it measures: RESOLUTION_9BIT to RESOLUTION_12BIT. */
    public int getResolution() {
        getData(REG_CONFIG, bytes, 1);
        return bytes[0] >>> RESOLUTION_SHIFT & RESOLUTION_12BIT;
    }

    /** Sets in which steps it measures: RESOLUTION_9BIT to RESOLUTION_12BIT. */
    public void setResolution(int resolution) {
        check(resolution);
        sendData(REG_CONFIG, (byte) (resolution << RESOLUTION_SHIFT));
    }

    /** Fails: this sensor does not tell its maker. */
    @Override
    public String getVendorID() {
        throw new UnsupportedOperationException();
    }

    /** Fails: this sensor does not tell its name. */
    @Override
    public String getProductID() {
        throw new UnsupportedOperationException();
    }

    /** Fails: this sensor does not tell its version. */
    @Override
    public String getVersion() {
        throw new UnsupportedOperationException();
    }

    private static void check(int resolution) {
        if (resolution < RESOLUTION_9BIT || resolution > RESOLUTION_12BIT) throw new IllegalArgumentException();
    }
}
