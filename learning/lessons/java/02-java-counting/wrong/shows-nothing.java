// hint: line missing
import josx.platform.rcx.*;

public class Countdown {
    public static void main(String[] args) throws InterruptedException {
        for (int i = 3; i >= 1; i--) {
            Thread.sleep(1000);
        }
        Sound.beep();
        Thread.sleep(500);
    }
}
