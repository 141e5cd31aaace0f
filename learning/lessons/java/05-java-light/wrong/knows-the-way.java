// hint: again
import josx.platform.rcx.*;

public class Edge {
    public static void main(String[] args) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2800);
        Motor.A.stop();
        Motor.C.stop();
        Sound.beep();
        Thread.sleep(500);
    }
}
