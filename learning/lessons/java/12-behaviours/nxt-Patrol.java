import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.subsumption.*;

public class Patrol {
    static DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);

    public static void main(String[] args) {
        pilot.setTravelSpeed(20);
        TouchSensor left = new TouchSensor(SensorPort.S1);
        TouchSensor right = new TouchSensor(SensorPort.S2);
        Behavior[] behaviors = {
            new Drive(),
            new Avoid(left, -20),
        };
        new Arbitrator(behaviors).start();
    }

    static class Drive implements Behavior {
        private volatile boolean isOver;

        public boolean takeControl() {
            return true;
        }

        public void action() {
            isOver = false;
            pilot.forward();
            while (!isOver) {
                Thread.yield();
            }
            pilot.stop();
        }

        public void suppress() {
            isOver = true;
        }
    }

    static class Avoid implements Behavior {
        private final TouchSensor bumper;
        private final int angle;

        Avoid(TouchSensor bumper, int angle) {
            this.bumper = bumper;
            this.angle = angle;
        }

        public boolean takeControl() {
            return bumper.isPressed();
        }

        public void action() {
            pilot.travel(-5);
            pilot.rotate(angle);
        }

        public void suppress() {
            // It is over soon.
        }
    }
}
