import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;

/** Does two things at once: one thread drives in circles, the other counts the seconds. */
public class TwoThings {
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

    public static void main(String[] arguments) throws InterruptedException {
        new Counter().start();
        for (int circle = 0; circle < 5; circle++) {
            Motor.A.setPower(3);
            Motor.C.setPower(7);
            Motor.A.forward();
            Motor.C.forward();
            Thread.sleep(1500);
            Motor.C.backward();
            Thread.sleep(500);
        }
        Motor.A.stop();
        Motor.C.stop();
    }
}
