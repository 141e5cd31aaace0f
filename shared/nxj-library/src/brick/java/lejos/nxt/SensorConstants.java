package lejos.nxt;

/** The numbers of types and modes of sensors. */
public interface SensorConstants {
    /** No sensor. */
    int TYPE_NO_SENSOR = 0;

    /** A touch sensor. */
    int TYPE_SWITCH = 1;

    /** A temperature sensor of an RCX. */
    int TYPE_TEMPERATURE = 2;

    /** A light sensor of an RCX. */
    int TYPE_REFLECTION = 3;

    /** A rotation sensor of an RCX. */
    int TYPE_ANGLE = 4;

    /** A light sensor with its lamp on. */
    int TYPE_LIGHT_ACTIVE = 5;

    /** A light sensor with its lamp off. */
    int TYPE_LIGHT_INACTIVE = 6;

    /** A sound sensor that hears all tones alike. */
    int TYPE_SOUND_DB = 7;

    /** A sound sensor that hears like an ear. */
    int TYPE_SOUND_DBA = 8;

    /** A sensor of another kind. */
    int TYPE_CUSTOM = 9;

    /** A sensor that sends bytes. */
    int TYPE_LOWSPEED = 10;

    /** A sensor that sends bytes and needs 9 volts. */
    int TYPE_LOWSPEED_9V = 11;

    /** A fast connection, on port 4. */
    int TYPE_HISPEED = 12;

    /** A colour sensor whose lamp changes its colour. */
    int TYPE_COLORFULL = 13;

    /** A colour sensor whose lamp is red. */
    int TYPE_COLORRED = 14;

    /** A colour sensor whose lamp is green. */
    int TYPE_COLORGREEN = 15;

    /** A colour sensor whose lamp is blue. */
    int TYPE_COLORBLUE = 16;

    /** A colour sensor whose lamp is off. */
    int TYPE_COLORNONE = 17;

    /** The lowest type. */
    int MIN_TYPE = 0;

    /** The highest type. */
    int MAX_TYPE = 17;

    /** The highest value that a port measures. */
    int MAX_AD_RAW = 1023;

    /** Measures from 0 to 1023. */
    int MODE_RAW = 0x00;

    /** Measures 0 or 1. */
    int MODE_BOOLEAN = 0x20;

    /** Counts changes; not on this brick. */
    int MODE_TRANSITIONCNT = 0x40;

    /** Counts pulses; not on this brick. */
    int MODE_PERIODCOUNTER = 0x60;

    /** Measures in percent. */
    int MODE_PCTFULLSCALE = 0x80;

    /** Measures in degrees Celsius; not on this brick. */
    int MODE_CELSIUS = 0xA0;

    /** Measures in degrees Fahrenheit; not on this brick. */
    int MODE_FARENHEIT = 0xC0;

    /** Counts steps of an angle; not on this brick. */
    int MODE_ANGLESTEP = 0xE0;

    /** The place of red among the values of a colour sensor. */
    int RED_INDEX = 0;

    /** The place of green among the values of a colour sensor. */
    int GREEN_INDEX = 1;

    /** The place of blue among the values of a colour sensor. */
    int BLUE_INDEX = 2;

    /** The place of the value without lamp among those of a colour sensor. */
    int BLANK_INDEX = 3;

    /** What a colour sensor gives for black. */
    int BLACK = 1;

    /** What a colour sensor gives for blue. */
    int BLUE = 2;

    /** What a colour sensor gives for green. */
    int GREEN = 3;

    /** What a colour sensor gives for yellow. */
    int YELLOW = 4;

    /** What a colour sensor gives for red. */
    int RED = 5;

    /** What a colour sensor gives for white. */
    int WHITE = 6;
}
