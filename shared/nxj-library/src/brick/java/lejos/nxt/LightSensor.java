package lejos.nxt;

import lejos.robotics.Color;
import lejos.robotics.LampLightDetector;

/** A sensor that measures how bright it is, with a red lamp. */
public class LightSensor implements LampLightDetector, SensorConstants {
    private static final int HIGHEST = 1023;

    private final ADSensorPort port;
    private int zero;
    private int hundred = HIGHEST;
    private boolean isLampOn;

    /** Makes the sensor of a port, with its lamp on. */
    public LightSensor(ADSensorPort port) {
        this(port, true);
    }

    /** Makes the sensor of a port, and says whether its lamp is on. */
    public LightSensor(ADSensorPort port, boolean floodlight) {
        this.port = port;
        port.setMode(MODE_PCTFULLSCALE);
        setFloodlight(floodlight);
    }

    /** Switches the lamp on or off. */
    public void setFloodlight(boolean floodlight) {
        isLampOn = floodlight;
        port.setType(floodlight ? TYPE_LIGHT_ACTIVE : TYPE_LIGHT_INACTIVE);
    }

    /** Switches the lamp to Color.RED or Color.NONE, and says whether it has that colour. */
    public boolean setFloodlight(int color) {
        if (color != Color.RED && color != Color.NONE) return false;
        setFloodlight(color == Color.RED);
        return true;
    }

    /** Says whether the lamp is on. */
    public boolean isFloodlightOn() {
        return isLampOn;
    }

    /** Gives Color.RED if the lamp is on, and otherwise Color.NONE. */
    public int getFloodlight() {
        return isLampOn ? Color.RED : Color.NONE;
    }

    /** Gives how bright it is: 0 for what was set as dark, 100 for what was set as bright. */
    public int getLightValue() {
        return hundred == zero ? 0 : 100 * (getNormalizedLightValue() - zero) / (hundred - zero);
    }

    /** Gives how bright it is: 0 for what was set as dark, 100 for what was set as bright. */
    public int readValue() {
        return getLightValue();
    }

    /** Gives how bright it is: about 145 in the dark and 890 in the sun. */
    public int getNormalizedLightValue() {
        return HIGHEST - port.readRawValue();
    }

    /** Gives how bright it is: about 145 in the dark and 890 in the sun. */
    public int readNormalizedValue() {
        return getNormalizedLightValue();
    }

    /** Takes what the sensor sees now as dark. */
    public void calibrateLow() {
        zero = getNormalizedLightValue();
    }

    /** Takes what the sensor sees now as bright. */
    public void calibrateHigh() {
        hundred = getNormalizedLightValue();
    }

    /** Sets what is dark, 0 to 1023. */
    public void setLow(int low) {
        zero = low;
    }

    /** Sets what is bright, 0 to 1023. */
    public void setHigh(int high) {
        hundred = high;
    }

    /** Gives what is dark, 0 to 1023. */
    public int getLow() {
        return zero;
    }

    /** Gives what is bright, 0 to 1023. */
    public int getHigh() {
        return hundred;
    }
}
