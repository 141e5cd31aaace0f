// hint: again
import josx.platform.rcx.*;

public class Patrol {
    public static void main(String[] args) throws InterruptedException {
        Motor.C.forward();
        Thread.sleep(120);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(7000);
        Motor.A.stop();
        Motor.C.stop();
    }
}
