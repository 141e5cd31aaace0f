// hint: line too many
import josx.platform.rcx.*;

public class Squares {
    public static void main(String[] args) throws InterruptedException {
        Motor.B.forward();      // pen down
        Thread.sleep(200);
        Motor.B.stop();
        square(1000);
        square(500);
        square(1500);
        Motor.B.backward();     // pen up
        Thread.sleep(200);
        Motor.B.stop();
    }

    static void square(int milliseconds) throws InterruptedException {
        for (int side = 1; side <= 4; side++) {
            drive(milliseconds);
            turnLeft(450);
        }
    }

    static void drive(int milliseconds) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(milliseconds);
        Motor.A.stop();
        Motor.C.stop();
    }

    static void turnLeft(int milliseconds) throws InterruptedException {
        Motor.A.backward();
        Motor.C.forward();
        Thread.sleep(milliseconds);
        Motor.A.stop();
        Motor.C.stop();
    }
}
