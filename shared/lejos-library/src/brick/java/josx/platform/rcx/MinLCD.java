package josx.platform.rcx;

/** The brick's display with just enough for numbers, for programs that need all the memory. */
public class MinLCD {
    private MinLCD() {
    }

    /** Writes a number in one of the ways of LCDConstants; refresh shows it. */
    public static void setNumber(int code, int value, int point) {
        ROM.call((short) 0x1ff2, (short) code, (short) value, (short) point);
    }

    /** Shows what was written since the last time. */
    public static void refresh() {
        ROM.call((short) 0x27c8);
    }
}
