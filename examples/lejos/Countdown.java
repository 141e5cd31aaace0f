// Counts down from ten and takes off.
// Next: let it turn round and land.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sound;
import josx.platform.rcx.TextLCD;

public class Countdown {
    public static void main(String[] args) throws InterruptedException {
        for (int count = 10; count > 0; count--) {
            LCD.showNumber(count);
            Sound.beep();
            Thread.sleep(1000);
        }
        TextLCD.print("GO");
        Motor.A.setPower(7); // full speed
        Motor.C.setPower(7);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(1500);
    }
}
