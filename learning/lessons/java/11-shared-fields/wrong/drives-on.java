// hint: line too many
import josx.platform.rcx.*;

public class Watch {
    static volatile boolean isDark = false;

    public static void main(String[] args) throws InterruptedException {
        new Watcher().start();
        for (int steps = 0; !isDark; steps++) {
            LCD.showNumber(steps);
            drive(50);
        }
        Motor.A.stop();
        Motor.C.stop();
        Sound.beep();
        drive(1000);
        Thread.sleep(500);
    }

    static void drive(int milliseconds) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(milliseconds);
    }

    static class Watcher extends Thread {
        public void run() {
            Sensor.S2.activate();
            try {
                Thread.sleep(100);
                while (Sensor.S2.readValue() > 40) {
                    Thread.sleep(5);
                }
                isDark = true;
            } catch (InterruptedException enough) {
                return;
            }
        }
    }
}
