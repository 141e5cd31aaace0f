package josx.platform.rcx;

/** The brick's display: numbers and little pictures. */
public class LCD {
    private LCD() {
    }

    /** Shows a whole number from 0 to 9999 at once. */
    public static void showNumber(int value) {
        setNumber(LCDConstants.LCD_UNSIGNED, value, LCDConstants.LCD_DECIMAL_0);
        refresh();
    }

    /** Shows a digit from 0 to 9 on the right at once. */
    public static void showProgramNumber(int value) {
        setNumber(LCDConstants.LCD_PROGRAM, value, LCDConstants.LCD_DECIMAL_0);
        refresh();
    }

    /** Writes a number in one of the ways of LCDConstants; refresh shows it. */
    public static void setNumber(int code, int value, int point) {
        ROM.call((short) 0x1ff2, (short) code, (short) value, (short) point);
    }

    /** Shows what was written since the last time. */
    public static void refresh() {
        ROM.call((short) 0x27c8);
    }

    /** Draws one of the little pictures of Segment; refresh shows it. */
    public static void setSegment(int segment) {
        ROM.call((short) 0x1b62, (short) segment);
    }

    /** Takes away one of the little pictures of Segment; refresh shows it. */
    public static void clearSegment(int segment) {
        ROM.call((short) 0x1e4a, (short) segment);
    }

    /** Takes everything away; refresh shows it. */
    public static void clear() {
        ROM.call((short) 0x27ac);
    }
}
