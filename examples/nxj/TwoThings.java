// Does two things at once: main drives in circles, and a thread of its own counts the seconds.
// Next: let the thread play a tone each second.

import lejos.nxt.*;
import lejos.util.Delay;

public class TwoThings {
    static class Counter extends Thread {
        public void run() {
            for (int second = 1; ; second++) {
                Delay.msDelay(1000);
                LCD.drawInt(second, 4, 0, 0);
            }
        }
    }

    public static void main(String[] args) {
        Counter counter = new Counter();
        counter.setDaemon(true);
        counter.start();
        Motor.A.setSpeed(200);
        Motor.C.setSpeed(400);
        Motor.A.forward();
        Motor.C.forward();
        Delay.msDelay(10000);
        Motor.A.stop(true);
        Motor.C.stop();
    }
}
