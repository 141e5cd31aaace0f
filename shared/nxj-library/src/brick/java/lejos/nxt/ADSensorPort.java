package lejos.nxt;

/** A port for a sensor that gives one number. */
public interface ADSensorPort extends BasicSensorPort {
    /** Says whether a touch sensor is pressed. */
    boolean readBooleanValue();

    /** Measures from 0 to 1023. */
    int readRawValue();

    /** Measures: what comes out depends on the mode. */
    int readValue();

    /**
     * Measures several values from 0 to 1023.
     *
     * @hidden
     */
    int readRawValues(int[] values);

    /**
     * Measures several values: what comes out depends on the sensor.
     *
     * @hidden
     */
    int readValues(int[] values);
}
