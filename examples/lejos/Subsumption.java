import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.platform.rcx.Sound;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

/** Three behaviours: drive, play a tone when it is bright, and above all avoid what the bumpers touch. */
public class Subsumption {
    public static void main(String[] arguments) {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S2.activate();
        Behavior[] behaviors = {new Drive(), new Sing(), new Avoid()};
        new Arbitrator(behaviors).start();
    }

    static class Drive implements Behavior {
        public boolean takeControl() {
            return true;
        }

        public void action() {
            Motor.A.forward();
            Motor.C.forward();
        }

        public void suppress() {
            Motor.A.stop();
            Motor.C.stop();
        }
    }

    static class Sing implements Behavior {
        public boolean takeControl() {
            return Sensor.S2.readValue() > 60;
        }

        public void action() {
            Sound.playTone(880, 20);
        }

        public void suppress() {
        }
    }

    static class Avoid implements Behavior {
        private boolean isSuppressed;

        public boolean takeControl() {
            return Sensor.S1.readBooleanValue() || Sensor.S3.readBooleanValue();
        }

        public void action() {
            isSuppressed = false;
            Motor.A.backward();
            Motor.C.backward();
            pause(600);
            Motor.A.forward();
            pause(400);
            Motor.A.stop();
            Motor.C.stop();
        }

        public void suppress() {
            isSuppressed = true;
        }

        private void pause(int milliseconds) {
            int end = (int) System.currentTimeMillis() + milliseconds;
            while (!isSuppressed && (int) System.currentTimeMillis() - end < 0) Thread.yield();
        }
    }
}
