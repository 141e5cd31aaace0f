// hint: one too many
import josx.platform.rcx.*;

public class Siren {
    public static void main(String[] args) throws InterruptedException {
        new Beeper().start();
        for (int side = 1; side <= 4; side++) {
            drive(600);
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

    static class Beeper extends Thread {
        public void run() {
            for (int times = 0; times < 6; times++) {
                Sound.beep();
                try {
                    Thread.sleep(800);
                } catch (InterruptedException enough) {
                    return;
                }
            }
        }
    }
}
