package josx.platform.rcx;

/** The kinds of sensors and the ways to read them, for setTypeAndMode. */
public interface SensorConstants {
    /** Any sensor. */
    int SENSOR_TYPE_RAW = 0;

    /** A touch sensor. */
    int SENSOR_TYPE_TOUCH = 1;

    /** A temperature sensor. */
    int SENSOR_TYPE_TEMP = 2;

    /** A light sensor. */
    int SENSOR_TYPE_LIGHT = 3;

    /** A rotation sensor. */
    int SENSOR_TYPE_ROT = 4;

    /** Measures from 0 to 1023, as the brick does itself. */
    int SENSOR_MODE_RAW = 0x00;

    /** Measures 1 if pressed, otherwise 0. */
    int SENSOR_MODE_BOOL = 0x20;

    /** Counts each press and each release. */
    int SENSOR_MODE_EDGE = 0x40;

    /** Counts the presses. */
    int SENSOR_MODE_PULSE = 0x60;

    /** Measures from 0, dark, to 100, bright. */
    int SENSOR_MODE_PCT = 0x80;

    /** Measures tenths of a degree Celsius. */
    int SENSOR_MODE_DEGC = 0xA0;

    /** Measures tenths of a degree Fahrenheit. */
    int SENSOR_MODE_DEGF = 0xC0;

    /** Counts sixteenths of a turn. */
    int SENSOR_MODE_ANGLE = 0xE0;

    /** Asks readSensorValue for 0 to 1023. */
    int RAW_VALUE = 0;

    /** Asks readSensorValue for the value that the mode says. */
    int CANONICAL_VALUE = 1;

    /** Asks readSensorValue for 1 or 0. */
    int BOOLEAN_VALUE = 2;
}
