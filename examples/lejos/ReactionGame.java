// How fast are you? When it beeps, press View: the display shows your
// time in seconds.
// Next: buzz if View comes too soon.

import java.util.Random;
import josx.platform.rcx.Button;
import josx.platform.rcx.LCD;
import josx.platform.rcx.LCDConstants;
import josx.platform.rcx.Sound;
import josx.platform.rcx.TextLCD;

public class ReactionGame {
    public static void main(String[] args) throws InterruptedException {
        TextLCD.print("READY");
        Thread.sleep(1000 + new Random().nextInt(2000));
        Sound.beep();
        int began = now();
        while (!Button.VIEW.isPressed()) Thread.yield();
        int milliseconds = now() - began;
        LCD.clear();
        LCD.setNumber(LCDConstants.LCD_SIGNED, milliseconds, LCDConstants.LCD_DECIMAL_3);
        LCD.refresh();
    }

    static int now() {
        return (int) System.currentTimeMillis();
    }
}
