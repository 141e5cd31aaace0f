package lejos.nxt;

import lejos.util.Delay;

/**
 * The brick's display: 100 dots wide and 64 high, or 16 characters in each of 8 rows.
 *
 * <p>What is drawn becomes visible a quarter of a second later, or at once by refresh.
 */
public class LCD {
    /** The width in dots. */
    public static final int SCREEN_WIDTH = 100;

    /** The height in dots. */
    public static final int SCREEN_HEIGHT = 64;

    /** How many characters there are. */
    public static final int NOOF_CHARS = 128;

    /** The width of a character in dots. */
    public static final int FONT_WIDTH = 5;

    /** The height of a character in dots. */
    public static final int FONT_HEIGHT = 8;

    /** The width of a character and the gap behind it in dots. */
    public static final int CELL_WIDTH = FONT_WIDTH + 1;

    /** The height of a row in dots. */
    public static final int CELL_HEIGHT = FONT_HEIGHT;

    /** How many characters a row has. */
    public static final int DISPLAY_CHAR_WIDTH = SCREEN_WIDTH / CELL_WIDTH;

    /** How many rows there are. */
    public static final int DISPLAY_CHAR_DEPTH = SCREEN_HEIGHT / CELL_HEIGHT;

    /** The milliseconds from one automatic refresh to the next. */
    public static final int DEFAULT_REFRESH_PERIOD = 250;

    // What bitBlt makes of a dot d of the target and a dot s of the source: the bytes of the number, from the highest
    // one, say whether to take d & s, d, s and 1; those that are taken are combined by exclusive or.

    /** The target becomes white. */
    public static final int ROP_CLEAR = 0x00000000;

    /** The target stays black where both are. */
    public static final int ROP_AND = 0xff000000;

    /** The target becomes black where only the source is. */
    public static final int ROP_ANDREVERSE = 0xff00ff00;

    /** The target becomes the source. */
    public static final int ROP_COPY = 0x0000ff00;

    /** The target becomes white where the source is black. */
    public static final int ROP_ANDINVERTED = 0xffff0000;

    /** The target stays as it is. */
    public static final int ROP_NOOP = 0x00ff0000;

    /** The target changes where the source is black. */
    public static final int ROP_XOR = 0x00ffff00;

    /** The target becomes black where the source is. */
    public static final int ROP_OR = 0xffffff00;

    /** The target becomes black where both are white. */
    public static final int ROP_NOR = 0xffffffff;

    /** The target becomes black where both are the same. */
    public static final int ROP_EQUIV = 0x00ffffff;

    /** The target becomes its opposite. */
    public static final int ROP_INVERT = 0x00ff00ff;

    /** The target becomes white only where it is black and the source white. */
    public static final int ROP_ORREVERSE = 0xffff00ff;

    /** The target becomes the opposite of the source. */
    public static final int ROP_COPYINVERTED = 0x0000ffff;

    /** The target becomes white only where it is white and the source black. */
    public static final int ROP_ORINVERTED = 0xff00ffff;

    /** The target becomes white where both are black. */
    public static final int ROP_NAND = 0xff0000ff;

    /** The target becomes black. */
    public static final int ROP_SET = 0x000000ff;

    private static final byte[] display = getDisplay();
    private static final byte[] font = getSystemFont();

    private static boolean isByHand;

    /** Makes one, which nobody needs. */
    public LCD() {
    }

    /** Writes a text, beginning in a column, 0 to 15, of a row, 0 to 7. */
    public static native void drawString(String text, int x, int y);

    /** Writes a text, and says whether it is to be white on black. */
    public static void drawString(String text, int x, int y, boolean inverted) {
        if (!inverted) {
            drawString(text, x, y);
            return;
        }
        char[] characters = text.toCharArray();
        int top = y * CELL_HEIGHT;
        bitBlt(display, SCREEN_WIDTH, SCREEN_HEIGHT, 0, 0, x * CELL_WIDTH, top, characters.length * CELL_WIDTH,
            CELL_HEIGHT, ROP_SET);
        for (int i = 0; i < characters.length; i++) drawChar(characters[i], x + i, y, ROP_COPYINVERTED);
    }

    /** Writes a whole number, beginning in a column of a row. */
    public static native void drawInt(int number, int x, int y);

    /** Writes a whole number with blanks before it, so that it takes so many columns. */
    public static native void drawInt(int number, int places, int x, int y);

    /** Writes a character in a column of a row; the gap behind it stays as it is. */
    public static void drawChar(char character, int x, int y) {
        drawChar(character, x, y, ROP_COPY);
    }

    private static void drawChar(char character, int x, int y, int operation) {
        if (character >= NOOF_CHARS) return;
        int left = character * FONT_WIDTH;
        bitBlt(font, NOOF_CHARS * FONT_WIDTH, FONT_HEIGHT, left, 0, x * CELL_WIDTH, y * CELL_HEIGHT, FONT_WIDTH,
            FONT_HEIGHT, operation);
    }

    /** Clears the display. */
    public static native void clear();

    /** Clears a row. */
    public static void clear(int y) {
        int top = y * CELL_HEIGHT;
        bitBlt(display, SCREEN_WIDTH, SCREEN_HEIGHT, 0, top, 0, top, SCREEN_WIDTH, CELL_HEIGHT, ROP_CLEAR);
    }

    /** Clears so many characters of a row, beginning in a column. */
    public static void clear(int x, int y, int count) {
        int left = x * CELL_WIDTH;
        int top = y * CELL_HEIGHT;
        bitBlt(display, SCREEN_WIDTH, SCREEN_HEIGHT, left, top, left, top, count * CELL_WIDTH, CELL_HEIGHT, ROP_CLEAR);
    }

    /** Clears the display. */
    public static void clearDisplay() {
        clear();
    }

    /** Makes visible what was drawn. */
    public static void refresh() {
        asyncRefresh();
        if (isByHand) asyncRefreshWait();
    }

    /** Begins to make visible what was drawn, and goes on at once. */
    public static native void asyncRefresh();

    /** Waits until everything is visible that was there when the last refresh began. */
    public static void asyncRefreshWait() {
        int rest = getRefreshCompleteTime() - (int) System.currentTimeMillis();
        if (rest > 0) Delay.msDelay(rest);
    }

    /** Gives when the last refresh is complete, as the lower half of currentTimeMillis. */
    public static native int getRefreshCompleteTime();

    /** Sets whether what is drawn becomes visible by itself. */
    public static void setAutoRefresh(boolean on) {
        isByHand = !on;
        setAutoRefreshPeriod(on ? DEFAULT_REFRESH_PERIOD : 0);
    }

    /** Sets after how many milliseconds what is drawn becomes visible, 0 for never, and gives the number before. */
    public static native int setAutoRefreshPeriod(int period);

    /** Makes a dot black for 1 and white for 0. */
    public static void setPixel(int x, int y, int color) {
        if (x < 0 || x >= SCREEN_WIDTH || y < 0 || y >= SCREEN_HEIGHT) return;
        int place = (y >> 3) * SCREEN_WIDTH + x;
        int bit = 1 << (y & 7);
        display[place] = (byte) (color == 0 ? display[place] & ~bit : display[place] | bit);
    }

    /** Gives 1 for a black dot and 0 for a white one. */
    public static int getPixel(int x, int y) {
        if (x < 0 || x >= SCREEN_WIDTH || y < 0 || y >= SCREEN_HEIGHT) return 0;
        return display[(y >> 3) * SCREEN_WIDTH + x] >> (y & 7) & 1;
    }

    /** Moves everything up by a row and clears the last one. */
    public static void scroll() {
        System.arraycopy(display, SCREEN_WIDTH, display, 0, display.length - SCREEN_WIDTH);
        clear(DISPLAY_CHAR_DEPTH - 1);
    }

    /** Combines a part of a picture with a part of the display; the last number is one of those that begin with ROP. */
    public static void bitBlt(byte[] source, int sourceWidth, int sourceHeight, int sourceX, int sourceY, int targetX,
            int targetY, int width, int height, int operation) {
        bitBlt(source, sourceWidth, sourceHeight, sourceX, sourceY, display, SCREEN_WIDTH, SCREEN_HEIGHT, targetX,
            targetY, width, height, operation);
    }

    /** Combines a part of a picture with a part of another. */
    public static native void bitBlt(byte[] source, int sourceWidth, int sourceHeight, int sourceX, int sourceY,
            byte[] target, int targetWidth, int targetHeight, int targetX, int targetY, int width, int height,
            int operation);

    /** Gives the dots: eight rows of 100 bytes, in which the lowest bit is the upper dot. */
    public static native byte[] getDisplay();

    /** Gives the characters as one picture. */
    public static native byte[] getSystemFont();

    /** Sets how black dots are, 0 to 96. */
    public static native void setContrast(int contrast);
}
