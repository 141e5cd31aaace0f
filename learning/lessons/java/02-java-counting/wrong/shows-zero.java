// hint: line too many
import josx.platform.rcx.*;

public class Countdown {
    public static void main(String[] args) throws InterruptedException {
        for (int i = 3; i >= 1; i--) {
            LCD.showNumber(i);
            Thread.sleep(1000);
        }
        Sound.beep();
        Thread.sleep(500);
        LCD.showNumber(0);
        Thread.sleep(500);
    }
}
