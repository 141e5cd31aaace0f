package lejos.nxt;

import lejos.util.Delay;

/** One of the four ports for sensors: SensorPort.S1 to SensorPort.S4. */
public class SensorPort implements LegacySensorPort, I2CPort, ListenerCaller {
    /** How many ports for sensors the brick has. */
    public static final int NUMBER_OF_PORTS = 4;

    /** The voltage of the port is what its resistor gives. */
    public static final int POWER_STD = 0;

    /** The port gives 9 volts, except while it measures. */
    public static final int POWER_RCX9V = 1;

    /** The port gives 9 volts. */
    public static final int POWER_9V = 2;

    /** The first line for bits. */
    public static final int SP_DIGI0 = 0;

    /** The second line for bits. */
    public static final int SP_DIGI1 = 1;

    /** The line that measures. */
    public static final int SP_ANA = 2;

    /** The line is not used. */
    public static final int SP_MODE_OFF = 0;

    /** The line is read. */
    public static final int SP_MODE_INPUT = 1;

    /** The line is set. */
    public static final int SP_MODE_OUTPUT = 2;

    /** The line measures. */
    public static final int SP_MODE_ADC = 3;

    /** The port 1. */
    public static final SensorPort S1 = new SensorPort(0);

    /** The port 2. */
    public static final SensorPort S2 = new SensorPort(1);

    /** The port 3. */
    public static final SensorPort S3 = new SensorPort(2);

    /** The port 4. */
    public static final SensorPort S4 = new SensorPort(3);

    /**
     * All four ports in their order.
     *
     * @deprecated use getInstance.
     */
    @Deprecated
    public static final SensorPort[] PORTS = {S1, S2, S3, S4};

    private static final int MOST_LISTENERS = 8;
    private static final int LISTENER_PERIOD = 4;
    private static final int PRESSED_BELOW = 600;
    private static final int HIGHEST = 1023;

    /** Red, green, blue and the light without lamp. */
    private static final int COLOR_VALUES = 4;

    /** A colour none of whose parts is as bright as this, 0 to 255, is black. */
    private static final int BLACK_BELOW = 70;

    /** A colour without hue that is less bright than this is black, too. */
    private static final int WHITE_FROM = 110;

    private final int id;
    private int type = TYPE_NO_SENSOR;
    private int mode = MODE_RAW;
    private SensorPortListener[] listeners;
    private int count;
    private int tolerance = 2;
    private int previousValue;

    private SensorPort(int id) {
        this.id = id;
    }

    /** Gives the port with a number, 0 for port 1 to 3 for port 4. */
    public static SensorPort getInstance(int id) {
        if (id < 0 || id >= NUMBER_OF_PORTS) throw new IllegalArgumentException();
        return PORTS[id];
    }

    /** Gives the number of the port less one: 0 to 3. */
    public final int getId() {
        return id;
    }

    /** Gives which kind of sensor it has. */
    public final int getType() {
        return type;
    }

    /** Gives how the port measures. */
    public final int getMode() {
        return mode;
    }

    /** Sets which kind of sensor it has, and gives that its power. */
    public void setType(int type) {
        if (type < MIN_TYPE || type > MAX_TYPE) throw new IllegalArgumentException();
        if (type == this.type) return;
        this.type = type;
        boolean isOfRcx = type >= TYPE_TEMPERATURE && type <= TYPE_ANGLE;
        setTypeById(id, type);
        setPowerType(isOfRcx ? POWER_RCX9V : type == TYPE_LOWSPEED_9V ? POWER_9V : POWER_STD);
        if (type >= TYPE_COLORFULL) return;
        setSensorPinMode(SP_DIGI0, SP_MODE_OUTPUT);
        setSensorPinMode(SP_DIGI1, SP_MODE_OUTPUT);
        setSensorPin(SP_DIGI0, type == TYPE_LIGHT_ACTIVE || type == TYPE_SOUND_DB ? 1 : 0);
        setSensorPin(SP_DIGI1, type == TYPE_SOUND_DBA ? 1 : 0);
    }

    /** Sets how the port measures: MODE_RAW, MODE_BOOLEAN or MODE_PCTFULLSCALE. */
    public void setMode(int mode) {
        this.mode = mode;
    }

    /** Sets which kind of sensor it has and how it measures. */
    public void setTypeAndMode(int type, int mode) {
        setType(type);
        setMode(mode);
    }

    /** Makes the port as it was when the program began. */
    public void reset() {
        i2cDisable();
        setTypeAndMode(TYPE_NO_SENSOR, MODE_RAW);
    }

    /** Gives a sensor of an RCX power. */
    public void activate() {
        setPowerType(POWER_RCX9V);
    }

    /** Takes the power from a sensor of an RCX. */
    public void passivate() {
        setPowerType(POWER_STD);
    }

    /** Sets the power that the sensor gets: POWER_STD, POWER_RCX9V or POWER_9V. */
    public void setPowerType(int type) {
        setPowerTypeById(id, type);
    }

    /** Measures from 0 to 1023; -1 if the port has no type. */
    public final int readRawValue() {
        if (type == TYPE_NO_SENSOR) return -1;
        if (type >= TYPE_COLORFULL) {
            int[] values = new int[4];
            if (readColourById(id, values) < 0) return -1;
            return values[type == TYPE_COLORRED || type == TYPE_COLORFULL ? RED_INDEX
                : type == TYPE_COLORGREEN ? GREEN_INDEX : type == TYPE_COLORBLUE ? BLUE_INDEX : BLANK_INDEX];
        }
        return readSensorValue(id);
    }

    /** Measures: 0 or 1, percent, or 0 to 1023, as the mode says; a colour sensor gives the number of its colour. */
    public int readValue() {
        if (type == TYPE_COLORFULL) return readColor();
        int raw = readRawValue();
        if (mode == MODE_BOOLEAN) return raw < PRESSED_BELOW ? 1 : 0;
        if (mode == MODE_PCTFULLSCALE && raw >= 0) return (HIGHEST - raw) * 100 / HIGHEST;
        return raw;
    }

    /** Says whether a touch sensor is pressed. */
    public final boolean readBooleanValue() {
        return readRawValue() < PRESSED_BELOW;
    }

    /** Measures red, green and blue, and the light without lamp, 0 to 255 each; gives how many. */
    public int readValues(int[] values) {
        if (type != TYPE_COLORFULL) {
            values[0] = readValue();
            return 1;
        }
        if (readColourById(id, values) < 0) return -1;
        for (int index = 0; index < COLOR_VALUES; index++) values[index] >>= 2;
        return COLOR_VALUES;
    }

    /** Measures red, green and blue, and the light without lamp, 0 to 1023 each; gives how many. */
    public int readRawValues(int[] values) {
        if (type != TYPE_COLORFULL) {
            values[0] = readRawValue();
            return 1;
        }
        return readColourById(id, values) < 0 ? -1 : COLOR_VALUES;
    }

    /** Gets a colour sensor ready. */
    public void enableColorSensor() {
        setType(TYPE_COLORFULL);
    }

    /**
     * Tells a listener from now on when the value changes; there can be eight.
     *
     * @deprecated ask the sensor instead.
     */
    @Deprecated
    public synchronized void addSensorPortListener(SensorPortListener listener) {
        boolean isFirst = listeners == null;
        if (isFirst) listeners = new SensorPortListener[MOST_LISTENERS];
        listeners[count] = listener;
        count++;
        if (isFirst) {
            previousValue = readSensorValue(id);
            ListenerThread.watch(this, NXTEvent.ANALOG_PORTS, 1 << id, LISTENER_PERIOD);
        }
    }

    /** Sets by how much the value must change, so that listeners are told; 2 if nobody sets it. */
    public void setListenerTolerance(int tolerance) {
        this.tolerance = tolerance;
    }

    /** Tells all listeners; the brick calls it, programs need not. */
    public synchronized int callListeners() {
        int value = readSensorValue(id);
        int change = value - previousValue;
        if (change > tolerance || change < -tolerance) {
            int old = previousValue;
            previousValue = value;
            for (int index = 0; index < count; index++) listeners[index].stateChanged(this, old, value);
        }
        return NXTEvent.ANALOG_PORTS;
    }

    /** Gets the port ready for a sensor that sends bytes. */
    public void i2cEnable(int mode) {
        i2cEnableById(id, mode);
    }

    /** Lets the port rest. */
    public void i2cDisable() {
        i2cDisableById(id);
    }

    /** Gives 0 if the port is ready, and otherwise what is the matter. */
    public int i2cStatus() {
        return i2cStatusById(id);
    }

    /** Begins to send bytes to a sensor, which is to answer with so many; gives 0, or below 0 what went wrong. */
    public int i2cStart(int address, byte[] writeBuffer, int writeOffset, int writeLen, int readLen) {
        return i2cStartById(id, address, writeBuffer, writeOffset, writeLen, readLen);
    }

    /** Waits until the sensor has answered. */
    public void i2cWaitIOComplete() {
        awaitBytes();
    }

    /** Takes the answer of the sensor; gives how many bytes it has, or below 0 what went wrong or that it is not there. */
    public int i2cComplete(byte[] buffer, int offset, int numBytes) {
        return i2cCompleteById(id, buffer, offset, numBytes);
    }

    /** Sends bytes to a sensor and waits for its answer; gives how many bytes that has, or below 0 what went wrong. */
    public synchronized int i2cTransaction(int deviceAddress, byte[] writeBuf, int writeOffset, int writeLen,
            byte[] readBuf, int readOffset, int readLen) {
        awaitBytes();
        int status = i2cStartById(id, deviceAddress, writeBuf, writeOffset, writeLen, readLen);
        if (status < 0) return status;
        awaitBytes();
        return i2cCompleteById(id, readBuf, readOffset, readLen);
    }

    /** Sets how a line is used: SP_MODE_OFF, SP_MODE_INPUT, SP_MODE_OUTPUT or SP_MODE_ADC. */
    public void setSensorPinMode(int pin, int mode) {
        setSensorPinMode(id, pin, mode);
    }

    /** Sets the bit of a line. */
    public void setSensorPin(int pin, int value) {
        setSensorPin(id, pin, value);
    }

    /** Gives the bit of a line. */
    public int getSensorPin(int pin) {
        return getSensorPin(id, pin);
    }

    /** Measures a line. */
    public int readSensorPin(int pin) {
        return readSensorPin(id, pin);
    }

    /** The colour that a colour sensor sees: BLACK to WHITE, below 0 if there is none. */
    private int readColor() {
        int[] values = new int[COLOR_VALUES];
        if (readValues(values) < 0) return -1;
        int red = values[RED_INDEX];
        int green = values[GREEN_INDEX];
        int blue = values[BLUE_INDEX];
        int brightest = Math.max(red, Math.max(green, blue));
        int darkest = Math.min(red, Math.min(green, blue));
        int near = brightest / 4;
        if (brightest < BLACK_BELOW) return BLACK;
        if (brightest - darkest < near) return brightest < WHITE_FROM ? BLACK : WHITE;
        if (brightest == blue) return BLUE;
        boolean isYellow = Math.abs(red - green) < brightest / 3 && Math.min(red, green) - blue > near;
        if (isYellow) return YELLOW;
        return brightest == red ? RED : GREEN;
    }

    private void awaitBytes() {
        while (i2cStatusById(id) == ERR_BUSY) Delay.msDelay(1);
    }

    static native int readSensorValue(int id);

    static native void setPowerTypeById(int id, int type);

    static native void setSensorPinMode(int id, int pin, int mode);

    static native void setSensorPin(int id, int pin, int value);

    static native int getSensorPin(int id, int pin);

    static native int readSensorPin(int id, int pin);

    static native void i2cEnableById(int id, int mode);

    static native void i2cDisableById(int id);

    static native int i2cStatusById(int id);

    static native int i2cStartById(int id, int address, byte[] write, int offset, int length, int readLength);

    static native int i2cCompleteById(int id, byte[] read, int offset, int length);

    static native void setTypeById(int id, int type);

    static native int readColourById(int id, int[] values);
}
