package lejos.nxt.addon;

import lejos.nxt.LegacySensorPort;
import lejos.nxt.SensorConstants;

/** The temperature sensor of an RCX, with an adapter cable. */
public class RCXThermometer implements SensorConstants {
    private static final int RAW_OF_0_DEGREES = 785;
    private static final float RAW_OF_A_DEGREE = 8;

    private final LegacySensorPort port;

    /** Makes the sensor of a port. */
    public RCXThermometer(LegacySensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_TEMPERATURE, MODE_RAW);
    }

    /** Measures from 0 to 1023, less where it is warmer. */
    public int readValue() {
        return port.readRawValue();
    }

    /** Gives about how warm it is, in degrees Celsius: 33.5 at 30 degrees, 57.4 at 60. */
    public float getCelcius() {
        return (RAW_OF_0_DEGREES - readValue()) / RAW_OF_A_DEGREE;
    }

    /** Gives about how warm it is, in degrees Fahrenheit: 92 at 86 degrees. */
    public float getFahrenheit() {
        return getCelcius() * 1.8f + 32;
    }
}
