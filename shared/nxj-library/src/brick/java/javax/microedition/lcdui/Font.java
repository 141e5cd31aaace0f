package javax.microedition.lcdui;

import lejos.nxt.LCD;

/** How Graphics writes letters: in three sizes. */
public class Font {
    /** The size of letters that are three dots wide. */
    public static final int SIZE_SMALL = 8;

    /** The size of the letters that LCD has, too. */
    public static final int SIZE_MEDIUM = 0;

    /** The size of letters that are eight dots wide. */
    public static final int SIZE_LARGE = 16;

    /** Three columns for each character from the blank on; the bits of a character less '0' are dots from above. */
    private static final String SMALL =
        "0000G0303O:OFO=94B:EJ0300>AA>0:4:4>4P@04440@0H43OAOBO@IEBAEO74OGE9NEM1M3OEOGE?0:0@:04:A:::A:41E2"
        + ">EFN5NOE:>AAOA>OEAO51>AMO4OAOA8@?O:AO@@O6OO1N>A>O52>IFO5JBE91O1O@O?@?O<OK4K3L3IEC0OA34HAO0212PPP"
        + "120<BNOB<<BB<BO<FD4N5TZNO2L0M0PPMO<BAO@N6NN2L<B<nB<<BnL22DN:2?B>@N>@>NHNB<BVXNJFB4>A0O0A>4462OOO";

    private static final Font system = new Font(LCD.getSystemFont(), LCD.CELL_WIDTH, LCD.CELL_HEIGHT,
        LCD.CELL_HEIGHT - 1, LCD.FONT_WIDTH, LCD.NOOF_CHARS, 0);
    private static Font small;
    private static Font large;

    final byte[] glyphs;
    final int width;
    final int height;
    final int base;
    final int glyphWidth;
    final int glyphCount;
    final int firstChar;

    Font(byte[] glyphs, int width, int height, int base, int glyphWidth, int glyphCount, int firstChar) {
        this.glyphs = glyphs;
        this.width = width;
        this.height = height;
        this.base = base;
        this.glyphWidth = glyphWidth;
        this.glyphCount = glyphCount;
        this.firstChar = firstChar;
    }

    /** Gives the font of the letters that LCD has, too: 16 in a row. */
    public static Font getDefaultFont() {
        return system;
    }

    /** Gives the font of a size, such as SIZE_LARGE; the other numbers do not count. */
    public static Font getFont(int face, int style, int size) {
        if (size == SIZE_SMALL) return getSmallFont();
        return size == SIZE_LARGE ? getLargeFont() : getDefaultFont();
    }

    /** Gives the small font: 25 letters in a row, 10 rows. */
    public static synchronized Font getSmallFont() {
        if (small == null) {
            byte[] columns = new byte[SMALL.length()];
            for (int i = 0; i < columns.length; i++) columns[i] = (byte) (SMALL.charAt(i) - '0');
            small = new Font(columns, 4, 6, 5, 3, 96, 32);
        }
        return small;
    }

    /** Gives the large font: 10 letters in a row, 4 rows. */
    public static synchronized Font getLargeFont() {
        if (large == null) large = new Font(enlarged(), 10, 16, 14, 8, 96, 32);
        return large;
    }

    /** The letters of the system twice as high, with their outer and middle columns doubled. */
    private static byte[] enlarged() {
        int span = 96 * 8;
        byte[] columns = new byte[2 * span];
        for (int i = 0; i < span; i++) {
            int dots = system.glyphs[(32 + i / 8) * LCD.FONT_WIDTH + (i % 8 * 5 + 2) / 8];
            int high = 0;
            for (int bit = 0; bit < 8; bit++) {
                if ((dots & 1 << bit) != 0) high |= 3 << 2 * bit;
            }
            columns[i] = (byte) high;
            columns[span + i] = (byte) (high >> 8);
        }
        return columns;
    }

    /** Gives how many dots a row is high. */
    public int getHeight() {
        return height;
    }

    /** Gives how many dots the line on which the letters stand is below the top. */
    public int getBaselinePosition() {
        return base;
    }

    /** Gives how many dots a text is wide. */
    public int stringWidth(String str) {
        return str.length() * width;
    }
}
