package josx.platform.rcx;

/** The ways to show a number, for LCD.setNumber. */
public interface LCDConstants extends Segment {
    /** From -9999 to 9999. */
    int LCD_SIGNED = 0x3001;

    /** From 0 to 9999, always with four digits. */
    int LCD_UNSIGNED = 0x301F;

    /** The small digit on the right. */
    int LCD_PROGRAM = 0x3017;

    /** No point. */
    int LCD_DECIMAL_0 = 0x3002;

    /** One digit behind the point. */
    int LCD_DECIMAL_1 = 0x3003;

    /** Two digits behind the point. */
    int LCD_DECIMAL_2 = 0x3004;

    /** Three digits behind the point. */
    int LCD_DECIMAL_3 = 0x3005;
}
