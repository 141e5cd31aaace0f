package lejos.nxt.addon;

import lejos.nxt.LegacySensorPort;
import lejos.nxt.SensorConstants;
import lejos.robotics.Color;
import lejos.robotics.LampLightDetector;

/** The light sensor of an RCX, with an adapter cable. */
public class RCXLightSensor implements SensorConstants, LampLightDetector {
    private static final int HIGHEST = 1023;

    private final LegacySensorPort port;
    private int low;
    private int high = HIGHEST;
    private boolean isLampOn;

    /** Makes the sensor of a port, with its lamp on. */
    public RCXLightSensor(LegacySensorPort port) {
        this.port = port;
        port.setTypeAndMode(TYPE_REFLECTION, MODE_PCTFULLSCALE);
        setFloodlight(true);
    }

    /**
     * Switches the lamp on.
     *
     * @deprecated use setFloodlight(true).
     */
    @Deprecated
    public void activate() {
        setFloodlight(true);
    }

    /**
     * Switches the lamp off.
     *
     * @deprecated use setFloodlight(false).
     */
    @Deprecated
    public void passivate() {
        setFloodlight(false);
    }

    /**
     * Gives how bright it is, 0 to 100.
     *
     * @deprecated use getLightValue.
     */
    @Deprecated
    public int readValue() {
        return getLightValue();
    }

    /** Switches the lamp on or off; without power, the sensor is less good at telling bright from dark. */
    public void setFloodlight(boolean floodlight) {
        isLampOn = floodlight;
        if (floodlight) port.activate();
        else port.passivate();
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

    /** Gives how bright it is, 0 to 100, whatever was set as dark and as bright. */
    public int getLightValue() {
        return getNormalizedLightValue() * 100 / HIGHEST;
    }

    /** Gives how bright it is, 0 to 1023. */
    public int getNormalizedLightValue() {
        return HIGHEST - port.readRawValue();
    }

    /** Takes what the sensor sees now as dark. */
    public void calibrateLow() {
        low = getNormalizedLightValue();
    }

    /** Takes what the sensor sees now as bright. */
    public void calibrateHigh() {
        high = getNormalizedLightValue();
    }

    /** Sets what is dark, 0 to 1023. */
    public void setLow(int low) {
        this.low = low;
    }

    /** Sets what is bright, 0 to 1023. */
    public void setHigh(int high) {
        this.high = high;
    }

    /** Gives what is dark, 0 to 1023. */
    public int getLow() {
        return low;
    }

    /** Gives what is bright, 0 to 1023. */
    public int getHigh() {
        return high;
    }
}
