package lejos.nxt;

import lejos.robotics.RangeFinder;
import lejos.util.Delay;

/** A sensor that measures by sound how far away things are, up to 254 centimetres; 255 is nothing. */
public class UltrasonicSensor extends I2CSensor implements RangeFinder {
    /** It measures nothing. */
    public static final byte MODE_OFF = 0x00;

    /** It measures once. */
    public static final byte MODE_PING = 0x01;

    /** It measures again and again. */
    public static final byte MODE_CONTINUOUS = 0x02;

    /** It listens to other sensors. */
    public static final byte MODE_CAPTURE = 0x03;

    /** It begins anew. */
    public static final byte MODE_RESET = 0x04;

    private static final byte REG_FACTORY_DATA = 0x11;
    private static final byte REG_UNITS = 0x14;
    private static final byte REG_CONTINUOUS_INTERVAL = 0x40;
    private static final byte REG_MODE = 0x41;
    private static final byte REG_DISTANCE = 0x42;
    private static final byte REG_CALIBRATION = 0x4A;
    private static final int NOTHING = 255;
    private static final int MOST_DISTANCES = 8;

    // What the sensor needs, in milliseconds.
    private static final int COMMAND_DELAY = 5;
    private static final int CONTINUOUS_DELAY = 30;
    private static final int PING_DELAY = 50;

    private final byte[] one = new byte[1];
    private int mode = MODE_OFF;
    private int distance = NOTHING;
    private long nextCommand;
    private long nextData;

    /** Makes the sensor of a port, which measures again and again. */
    public UltrasonicSensor(I2CPort port) {
        super(port, DEFAULT_I2C_ADDRESS, I2CPort.LEGO_MODE, TYPE_LOWSPEED_9V);
        port.setMode(MODE_RAW);
        reset();
        setMode(MODE_CONTINUOUS);
    }

    /** Gives how far away the nearest thing is in centimetres, 255 if there is none; takes 30 milliseconds. */
    public synchronized int getDistance() {
        if (mode == MODE_OFF) throw new IllegalStateException();
        if (mode == MODE_PING && nextData == 0) return distance;
        await(nextData);
        distance = read(REG_DISTANCE, one, 0, 1) < 0 ? NOTHING : one[0] & 0xFF;
        nextData = mode == MODE_PING ? 0 : System.currentTimeMillis() + CONTINUOUS_DELAY;
        return distance;
    }

    /** Gives how far away the nearest thing is in centimetres, 255 if there is none. */
    public float getRange() {
        return getDistance();
    }

    /** Measures once, and gives how far away up to eight things are, the nearest first. */
    public synchronized float[] getRanges() {
        ping();
        int[] distances = new int[MOST_DISTANCES];
        int count = getDistances(distances);
        float[] ranges = new float[count < 0 ? 0 : count];
        for (int index = 0; index < ranges.length; index++) ranges[index] = distances[index];
        return ranges;
    }

    /** Fills the array with how far away things are, and gives how many, or below 0 what went wrong. */
    public int getDistances(int[] distances) {
        return getDistances(distances, 0, distances.length);
    }

    /** Fills a part of the array with how far away things are, and gives how many, or below 0 what went wrong. */
    public synchronized int getDistances(int[] distances, int offset, int len) {
        if (len < 0) throw new IllegalArgumentException();
        if (mode == MODE_OFF) throw new IllegalStateException();
        int wanted = Math.min(len, mode == MODE_PING ? MOST_DISTANCES : 1);
        if (wanted == 0) return 0;
        await(nextData);
        byte[] bytes = new byte[wanted];
        int status = read(REG_DISTANCE, bytes, 0, wanted);
        if (status < 0) return status;
        if (mode != MODE_PING) nextData = System.currentTimeMillis() + CONTINUOUS_DELAY;
        int count = 0;
        while (count < wanted && (bytes[count] & 0xFF) != NOTHING) {
            distances[offset + count] = bytes[count] & 0xFF;
            count++;
        }
        if (mode != MODE_PING && count == 0) {
            distances[offset] = NOTHING;
            count = 1;
        }
        return count;
    }

    /** Measures once; gives 0, or below 0 what went wrong. */
    public int ping() {
        return setMode(MODE_PING);
    }

    /** Measures again and again; gives 0, or below 0 what went wrong. */
    public int continuous() {
        return setMode(MODE_CONTINUOUS);
    }

    /** Listens to other sensors; gives 0, or below 0 what went wrong. */
    public int capture() {
        return setMode(MODE_CAPTURE);
    }

    /** Measures nothing; gives 0, or below 0 what went wrong. */
    public int off() {
        return setMode(MODE_OFF);
    }

    /** Begins anew, and measures nothing then; gives 0, or below 0 what went wrong. */
    public int reset() {
        return setMode(MODE_RESET);
    }

    /** Sets whether and how often it measures; gives 0, or below 0 what went wrong. */
    public synchronized int setMode(int mode) {
        one[0] = (byte) mode;
        await(nextCommand);
        int status = sendData(REG_MODE, one, 1);
        nextCommand = System.currentTimeMillis() + COMMAND_DELAY;
        // Also if no sensor answers: then there is nothing to measure, rather than a sensor that was switched off.
        this.mode = mode == MODE_RESET ? MODE_OFF : mode;
        nextData = System.currentTimeMillis() + (mode == MODE_PING ? PING_DELAY : CONTINUOUS_DELAY);
        return status;
    }

    /** Gives the mode that was set. */
    public int getMode() {
        return mode;
    }

    /** Asks the sensor for its mode; below 0 is what went wrong. */
    public synchronized int getActualMode() {
        return readNumber(REG_MODE);
    }

    /** Gives the unit of what it measures: 10E-2m are centimetres. */
    public String getUnits() {
        return fetchString(REG_UNITS, 7);
    }

    /** Gives how long it waits from one time to the next; below 0 is what went wrong. */
    public synchronized int getContinuousInterval() {
        return readNumber(REG_CONTINUOUS_INTERVAL);
    }

    /** Sets how long it waits from one time to the next; gives 0, or below 0 what went wrong. */
    public synchronized int setContinuousInterval(int interval) {
        await(nextCommand);
        int status = sendData(REG_CONTINUOUS_INTERVAL, (byte) interval);
        nextCommand = System.currentTimeMillis() + COMMAND_DELAY;
        return status;
    }

    /** Reads three bytes that the maker has set; gives 0, or below 0 what went wrong. */
    public synchronized int getFactoryData(byte[] data) {
        return read(REG_FACTORY_DATA, data, 0, 3);
    }

    /** Reads three bytes that setCalibrationData sets; gives 0, or below 0 what went wrong. */
    public synchronized int getCalibrationData(byte[] data) {
        return read(REG_CALIBRATION, data, 0, 3);
    }

    /** Sets three bytes; gives 0, or below 0 what went wrong. */
    public synchronized int setCalibrationData(byte[] data) {
        await(nextCommand);
        int status = sendData(REG_CALIBRATION, data, 3);
        nextCommand = System.currentTimeMillis() + COMMAND_DELAY;
        return status;
    }

    private int readNumber(byte register) {
        int status = read(register, one, 0, 1);
        return status < 0 ? status : one[0] & 0xFF;
    }

    private int read(byte register, byte[] bytes, int offset, int length) {
        await(nextCommand);
        int status = getData(register, bytes, offset, length);
        nextCommand = System.currentTimeMillis() + COMMAND_DELAY;
        return status;
    }

    private static void await(long time) {
        Delay.msDelay(time - System.currentTimeMillis());
    }
}
