package lejos.nxt.addon;

import lejos.nxt.I2CPort;
import lejos.nxt.I2CSensor;
import lejos.robotics.Color;
import lejos.robotics.ColorDetector;

/** The colour sensor of HiTechnic: it sees colours, about a centimetre away. */
public class ColorHTSensor extends I2CSensor implements ColorDetector {
    private static final int REG_MODE = 0x41;
    private static final int REG_COLOR = 0x42;
    private static final int REG_PARTS = 0x43;
    private static final int REG_RAW = 0x46;
    private static final int REG_INDEX = 0x4C;
    private static final int REG_NORMALIZED = 0x4D;
    private static final byte WHITE_BALANCE = 0x43;
    private static final byte BLACK_LEVEL = 0x42;

    /** The numbers of Color for those of the sensor. */
    private static final int[] COLORS = {
        Color.BLACK, Color.MAGENTA, Color.MAGENTA, Color.BLUE, Color.GREEN, Color.YELLOW, Color.YELLOW, Color.ORANGE,
        Color.RED, Color.RED, Color.MAGENTA, Color.MAGENTA, Color.YELLOW, Color.PINK, Color.PINK, Color.PINK,
        Color.MAGENTA, Color.WHITE};

    private final byte[] bytes = new byte[2];

    /** Makes the sensor of a port. */
    public ColorHTSensor(I2CPort port) {
        super(port);
    }

    /** Gives the colour as a number, such as Color.RED; -1 if no sensor answers. */
    public int getColorID() {
        int number = readByte(REG_COLOR);
        return number < 0 ? -1 : COLORS[number];
    }

    /** Gives the colour in six bits: two each for red, green and blue; -1 if no sensor answers. */
    public int getColorIndexNumber() {
        int index = readByte(REG_INDEX);
        return index < 0 ? -1 : index & 0x3F;
    }

    /** Gives how much of Color.RED, GREEN or BLUE it sees, 0 to 255; -1 if no sensor answers. */
    public int getRGBComponent(int color) {
        return readByte(REG_PARTS + color);
    }

    /** Gives the same, but 255 for the brightest of the three. */
    public int getRGBNormalized(int color) {
        return readByte(REG_NORMALIZED + color);
    }

    /** Gives how much of Color.RED, GREEN or BLUE it sees, 0 to 1023; -1 if no sensor answers. */
    public int getRGBRaw(int color) {
        if (getData(REG_RAW + 2 * color, bytes, 2) != 0) return -1;
        return (bytes[0] & 0xFF) << 8 | bytes[1] & 0xFF;
    }

    /** Gives what the sensor does: 0 if it measures; -1 if no sensor answers. */
    public int getMode() {
        return readByte(REG_MODE);
    }

    /** Takes what it sees as white; gives 0, or below 0 what went wrong. */
    public int initWhiteBalance() {
        return sendData(REG_MODE, WHITE_BALANCE);
    }

    /** Takes what it sees as black; gives 0, or below 0 what went wrong. */
    public int initBlackLevel() {
        return sendData(REG_MODE, BLACK_LEVEL);
    }

    /** Gives the colour as its red, green and blue, 0 to 255 each. */
    public Color getColor() {
        return new Color(getRGBComponent(Color.RED), getRGBComponent(Color.GREEN), getRGBComponent(Color.BLUE),
            getColorID());
    }

    private int readByte(int register) {
        return getData(register, bytes, 1) != 0 ? -1 : bytes[0] & 0xFF;
    }
}
