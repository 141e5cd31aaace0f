// Draws a spiral: each side is a little longer than the one before.
// Next: turn by 60 degrees, or by 91.

import josx.platform.rcx.Motor;

public class Spiral {
    static final int SIDES = 16;
    static final int FIRST_MILLISECONDS = 100;
    static final int GROWTH_MILLISECONDS = 100;
    static final int CORNER_MILLISECONDS = 90 * 5;

    public static void main(String[] args) throws InterruptedException {
        Motor.B.forward(); // the pen goes down
        Thread.sleep(200);
        Motor.B.stop();
        for (int side = 0; side < SIDES; side++) {
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(FIRST_MILLISECONDS + side * GROWTH_MILLISECONDS);
            Motor.A.backward();
            Thread.sleep(CORNER_MILLISECONDS);
        }
        Motor.A.stop();
        Motor.C.stop();
    }
}
