import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Siren {
    public static void main(String[] args) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        new Beeper().start();
        for (int side = 1; side <= 4; side++) {
            pilot.travel(8);
            pilot.rotate(90);
        }
    }

    static class Beeper extends Thread {
        public void run() {
            for (int times = 0; times < 5; times++) {
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
