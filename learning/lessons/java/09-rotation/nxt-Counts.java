import lejos.nxt.*;

public class Counts {
    public static void main(String[] args) throws InterruptedException {
        Motor.A.resetTachoCount();
        Motor.A.forward();
        Motor.C.forward();
        while (Motor.A.getTachoCount() < 360) {
            Thread.sleep(5);
        }
        Motor.A.stop(true);
        Motor.C.stop();
    }
}
