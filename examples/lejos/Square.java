import josx.platform.rcx.Motor;

/** Draws a square with the pen. */
public class Square {
    static final int SIDE_MILLISECONDS = 1000;
    static final int CORNER_MILLISECONDS = 450;

    public static void main(String[] arguments) throws InterruptedException {
        penDown();
        for (int side = 0; side < 4; side++) {
            forward();
            turnLeft();
        }
    }

    static void penDown() throws InterruptedException {
        Motor.B.forward();
        Thread.sleep(200);
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
