package lejos.nxt;

import lejos.robotics.ColorDetector;
import lejos.robotics.LampLightDetector;

/** A sensor that sees colours, about a centimetre away, and measures how bright it is. */
public class ColorSensor implements LampLightDetector, ColorDetector, SensorConstants {
    /** The numbers of Color for those that the port gives: none, black, blue, green, yellow, red, white. */
    protected static final int[] colorMap = {
        lejos.robotics.Color.NONE, lejos.robotics.Color.BLACK, lejos.robotics.Color.BLUE, lejos.robotics.Color.GREEN,
        lejos.robotics.Color.YELLOW, lejos.robotics.Color.RED, lejos.robotics.Color.WHITE};

    private static final int HIGHEST = 1023;
    private static final int RESET_TIME = 100;

    /** The port of the sensor. */
    protected SensorPort port;

    /** What the port is set to: a type of SensorConstants. */
    protected int type;

    private int lamp;
    private int zero;
    private int hundred = HIGHEST;

    /** Makes the sensor of a port, whose lamp changes its colour. */
    public ColorSensor(SensorPort port) {
        this(port, lejos.robotics.Color.WHITE);
    }

    /** Makes the sensor of a port, and sets the colour of its lamp: Color.WHITE, RED, GREEN, BLUE or NONE. */
    public ColorSensor(SensorPort port, int color) {
        this.port = port;
        port.enableColorSensor();
        lejos.util.Delay.msDelay(RESET_TIME);
        setFloodlight(color);
    }

    /** Gives the colour as a number, such as Color.RED; Color.NONE if it cannot see any. */
    public int getColorID() {
        int color = lamp;
        setType(TYPE_COLORFULL);
        int kind = port.readValue();
        setFloodlight(color);
        return kind < 0 || kind >= colorMap.length ? lejos.robotics.Color.NONE : colorMap[kind];
    }

    /** Gives the colour as its red, green and blue, 0 to 255 each. */
    public Color getColor() {
        int[] values = new int[4];
        int color = lamp;
        setType(TYPE_COLORFULL);
        boolean isThere = port.readValues(values) >= 0;
        int kind = port.readValue();
        setFloodlight(color);
        return isThere ? new Color(values, kind < 0 || kind >= colorMap.length ? 0 : kind) : null;
    }

    /** Gives the colour as its red, green and blue, 0 to 1023 each. */
    public Color getRawColor() {
        int[] values = new int[4];
        int color = lamp;
        setType(TYPE_COLORFULL);
        boolean isThere = port.readRawValues(values) >= 0;
        setFloodlight(color);
        return isThere ? new Color(values, 0) : null;
    }

    /** Gives how bright it is: 0 for what was set as dark, 100 for what was set as bright. */
    public int getLightValue() {
        return hundred == zero ? 0 : 100 * (getNormalizedLightValue() - zero) / (hundred - zero);
    }

    /** Gives how bright it is, 0 to 1023. */
    public int getNormalizedLightValue() {
        return port.readRawValue();
    }

    /** Gives how bright it is, 0 to 1023. */
    public int getRawLightValue() {
        return port.readRawValue();
    }

    /** Switches the lamp to red or off. */
    public void setFloodlight(boolean floodlight) {
        setFloodlight(floodlight ? lejos.robotics.Color.RED : lejos.robotics.Color.NONE);
    }

    /** Sets the colour of the lamp: Color.WHITE, RED, GREEN, BLUE or NONE; says whether it has that. */
    public boolean setFloodlight(int color) {
        int type;
        switch (color) {
            case lejos.robotics.Color.RED:
                type = TYPE_COLORRED;
                break;
            case lejos.robotics.Color.GREEN:
                type = TYPE_COLORGREEN;
                break;
            case lejos.robotics.Color.BLUE:
                type = TYPE_COLORBLUE;
                break;
            case lejos.robotics.Color.WHITE:
                type = TYPE_COLORFULL;
                break;
            case lejos.robotics.Color.NONE:
                type = TYPE_COLORNONE;
                break;
            default:
                return false;
        }
        lamp = color;
        setType(type);
        return true;
    }

    /** Says whether the lamp is on. */
    public boolean isFloodlightOn() {
        return lamp != lejos.robotics.Color.NONE;
    }

    /** Gives the colour of the lamp, Color.NONE if it is off. */
    public int getFloodlight() {
        return lamp;
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

    /** Sets the port to a type of SensorConstants. */
    protected void setType(int type) {
        this.type = type;
        if (port.getType() != type) port.setType(type);
    }

    /** A colour that the sensor sees. */
    public static class Color extends lejos.robotics.Color {
        private final int background;

        /** Makes one of so much red, green, blue and light without lamp, which has a number. */
        public Color(int red, int green, int blue, int background, int colorId) {
            super(red, green, blue, colorId);
            this.background = background;
        }

        Color(int[] values, int kind) {
            super(values[RED_INDEX], values[GREEN_INDEX], values[BLUE_INDEX], colorMap[kind]);
            background = values[BLANK_INDEX];
        }

        /** Gives how bright it is without the lamp. */
        public int getBackground() {
            return background;
        }
    }
}
