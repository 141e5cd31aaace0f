import josx.platform.rcx.LCD;
import josx.platform.rcx.LCDConstants;

public class LcdShowsOnlyAfterRefresh {
    public static void main(String[] arguments) {
        LCD.showNumber(5); // shows: 5
        LCD.setNumber(LCDConstants.LCD_SIGNED, -12, LCDConstants.LCD_DECIMAL_0);
        LCD.setNumber(LCDConstants.LCD_SIGNED, -13, LCDConstants.LCD_DECIMAL_0);
        LCD.refresh(); // shows: -13
        LCD.showNumber(10000); // shows: 9999
        LCD.showNumber(-1); // shows: 9999
        LCD.setNumber(LCDConstants.LCD_SIGNED, 25, LCDConstants.LCD_DECIMAL_1);
        LCD.refresh(); // shows: 2.5
    }
}
