import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Watch {
    static volatile boolean isDark = false;

    public static void main(String[] args) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        new Watcher().start();
        pilot.setTravelSpeed(20);
        pilot.forward();
        for (int steps = 0; !isDark; steps++) {
            LCD.drawInt(steps, 0, 0);
            Thread.sleep(50);
        }
        pilot.stop();
        Sound.beep();
        Thread.sleep(500);
    }

    static class Watcher extends Thread {
        public void run() {
            LightSensor light = new LightSensor(SensorPort.S3);
            try {
                Thread.sleep(100);
                while (light.readValue() > 40) {
                    Thread.sleep(5);
                }
            } catch (InterruptedException enough) {
                return;
            }
        }
    }
}
