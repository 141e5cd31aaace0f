// hint: line too many
import josx.platform.rcx.*;

public class Square {
    public static void main(String[] args) throws InterruptedException {
        Motor.B.forward();      // pen down
        Thread.sleep(200);
        Motor.B.stop();
        for (int side = 1; side <= 4; side++) {
            drive(1000);        // 20 centimetres
            turnLeft(450);      // 90 degrees
        }
        turnLeft(200);
        drive(1000);
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
