// hint: again
import josx.platform.rcx.*;

public class Watch {
    public static void main(String[] args) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2600);
        Motor.A.stop();
        Motor.C.stop();
        Sound.beep();
        Thread.sleep(500);
    }
}
