import lejos.nxt.Button;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.TouchSensor;
import lejos.robotics.subsumption.Arbitrator;
import lejos.robotics.subsumption.Behavior;

/** The well-known pair: drive on, and back off when something is hit. */
// sensor 1 at 0: raw 1023
// sensor 1 at 800: raw 183
// sensor 1 at 1000: raw 1023
// press ESCAPE at 3500
public class BehavioursWithMotors {
    static boolean isOver;

    static class Drive implements Behavior {
        private boolean isSuppressed;

        public boolean takeControl() {
            return !isOver;
        }

        public void action() {
            isSuppressed = false;
            Motor.A.forward();
            Motor.C.forward();
            System.out.println("drive");
            while (!isSuppressed && !Button.ESCAPE.isDown()) Thread.yield();
            Motor.A.stop(true);
            Motor.C.stop(true);
            if (Button.ESCAPE.isDown()) isOver = true;
        }

        public void suppress() {
            isSuppressed = true;
        }
    }

    static class Hit implements Behavior {
        private final TouchSensor bumper = new TouchSensor(SensorPort.S1);

        public boolean takeControl() {
            return bumper.isPressed();
        }

        public void action() {
            System.out.println("hit");
            Motor.A.rotate(-180, true);
            Motor.C.rotate(-360);
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        new Arbitrator(new Behavior[] {new Drive(), new Hit()}, true).start();
        Motor.A.waitComplete();
        System.out.println(Motor.A.isMoving() + " over");
    }
}

// expect drive
// expect hit
// expect drive
// expect false over
