import josx.platform.rcx.Motor;

/** Draws a spiral: each side is longer than the one before. */
public class Spiral {
    public static void main(String[] arguments) throws InterruptedException {
        Motor.B.forward();
        Thread.sleep(200);
        Motor.B.stop();
        for (int side = 1; side <= 12; side++) {
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(side * 100);
            Motor.A.backward();
            Thread.sleep(450);
        }
        Motor.A.stop();
        Motor.C.stop();
    }
}
