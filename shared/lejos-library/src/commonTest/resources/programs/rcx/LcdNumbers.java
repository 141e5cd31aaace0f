import josx.platform.rcx.LCD;
import josx.platform.rcx.LCDConstants;
import josx.platform.rcx.MinLCD;

public class LcdNumbers {
    public static void main(String[] arguments) {
        LCD.showNumber(42); // rom: 0x1ff2 0x301f 42 0x3002 | 0x27c8
        LCD.showProgramNumber(7); // rom: 0x1ff2 0x3017 7 0x3002 | 0x27c8
        LCD.setNumber(LCDConstants.LCD_SIGNED, -25, LCDConstants.LCD_DECIMAL_1); // rom: 0x1ff2 0x3001 -25 0x3003
        LCD.refresh(); // rom: 0x27c8
        LCD.setNumber(LCDConstants.LCD_UNSIGNED, 1234, LCDConstants.LCD_DECIMAL_2); // rom: 0x1ff2 0x301f 1234 0x3004
        LCD.clear(); // rom: 0x27ac
        MinLCD.setNumber(LCDConstants.LCD_SIGNED, 5, LCDConstants.LCD_DECIMAL_3); // rom: 0x1ff2 0x3001 5 0x3005
        MinLCD.refresh(); // rom: 0x27c8
        LCD.setNumber(LCDConstants.LCD_PROGRAM, 3, LCDConstants.LCD_DECIMAL_0); // rom: 0x1ff2 0x3017 3 0x3002
    }
}
