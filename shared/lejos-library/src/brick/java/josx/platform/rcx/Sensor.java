package josx.platform.rcx;

/** One of the three sensors: Sensor.S1, Sensor.S2 and Sensor.S3. */
public class Sensor implements SensorConstants, ListenerCaller {
    /** The sensor on port 1. */
    public static final Sensor S1 = new Sensor(0);

    /** The sensor on port 2. */
    public static final Sensor S2 = new Sensor(1);

    /** The sensor on port 3. */
    public static final Sensor S3 = new Sensor(2);

    /** All three sensors in their order. */
    public static final Sensor[] SENSORS = {S1, S2, S3};

    private static final int MOST_LISTENERS = 8;

    // What setSensorValue changes.
    private static final int MODE = 0;
    private static final int TYPE = 1;
    private static final int VALUE = 2;

    private final int id;
    private SensorListener[] listeners;
    private int count;
    private int previousValue;

    private Sensor(int id) {
        this.id = id;
        setTypeAndMode(SENSOR_TYPE_LIGHT, SENSOR_MODE_PCT);
    }

    /** Gives the number of the port less one: 0 to 2. */
    public final int getId() {
        return id;
    }

    /** Measures: what comes out depends on the mode, percent if nobody has set another. */
    public final int readValue() {
        return readSensorValue(id, CANONICAL_VALUE);
    }

    /** Measures from 0 to 1023, whatever the mode is. */
    public final int readRawValue() {
        return readSensorValue(id, RAW_VALUE);
    }

    /** Says whether a touch sensor is pressed. */
    public final boolean readBooleanValue() {
        return readSensorValue(id, BOOLEAN_VALUE) != 0;
    }

    /** Gives the sensor power: light sensors and rotation sensors need it. */
    public final void activate() {
        ROM.call((short) 0x1946, (short) (0x1000 + id));
    }

    /** Takes the power from the sensor. */
    public final void passivate() {
        ROM.call((short) 0x19c4, (short) (0x1000 + id));
    }

    /** Says which kind of sensor it is and how to read it; it does not activate the sensor. */
    public final void setTypeAndMode(int type, int mode) {
        setSensorValue(id, type, TYPE);
        setSensorValue(id, mode, MODE);
    }

    /** Lets a sensor that counts go on from this number. */
    public final void setPreviousValue(int value) {
        setSensorValue(id, value, VALUE);
    }

    /** Tells a listener from now on when the value changes; there can be eight. */
    public synchronized void addSensorListener(SensorListener listener) {
        if (listeners == null) listeners = new SensorListener[MOST_LISTENERS];
        listeners[count] = listener;
        count++;
        ListenerThread.watch(Poll.SENSOR1_MASK << id);
    }

    /** Measures on the port with this number less one: 0 raw, 1 as the mode says, 2 pressed or not. */
    public static native int readSensorValue(int id, int kind);

    /** Tells all listeners; the brick calls it, programs need not. */
    public synchronized void callListeners() {
        int value = readValue();
        for (int index = 0; index < count; index++) listeners[index].stateChanged(this, previousValue, value);
        previousValue = value;
    }

    private static native void setSensorValue(int id, int value, int kind);
}
