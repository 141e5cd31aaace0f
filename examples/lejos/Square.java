// Draws a square. The times are those of the penbot:
// 50 milliseconds for a centimetre, 5 for a degree.
// Next: make it a triangle. How long does it turn at each corner?

import josx.platform.rcx.Motor;

public class Square {
    static final int SIDE_MILLISECONDS = 20 * 50;
    static final int CORNER_MILLISECONDS = 90 * 5;
    static final int PEN_MILLISECONDS = 200;

    public static void main(String[] args) throws InterruptedException {
        penDown();
        for (int side = 0; side < 4; side++) {
            forward();
            turnLeft();
        }
    }

    static void penDown() throws InterruptedException {
        Motor.B.forward();
        Thread.sleep(PEN_MILLISECONDS);
        Motor.B.stop();
    }

    static void forward() throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(SIDE_MILLISECONDS);
        stop();
    }

    static void turnLeft() throws InterruptedException {
        Motor.A.backward();
        Motor.C.forward();
        Thread.sleep(CORNER_MILLISECONDS);
        stop();
    }

    static void stop() {
        Motor.A.stop();
        Motor.C.stop();
    }
}
