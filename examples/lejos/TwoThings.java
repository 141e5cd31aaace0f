// Does two things at once: main drives in circles, and a thread of its
// own counts the seconds.
// Next: add a thread that beeps every two seconds.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;

public class TwoThings {
    public static void main(String[] args) throws InterruptedException {
        new Counter().start();
        Motor.A.setPower(1);
        Motor.C.setPower(7);
        for (int circle = 0; circle < 4; circle++) {
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(1500);
            Motor.A.stop();
            Thread.sleep(500);
        }
        Motor.C.stop();
    }

    static class Counter extends Thread {
        public void run() {
            for (int second = 0; second <= 10; second++) {
                LCD.showNumber(second);
                try {
                    Thread.sleep(1000);
                } catch (InterruptedException enough) {
                    return;
                }
            }
        }
    }
}
