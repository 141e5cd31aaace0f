// The wall bouncer with behaviours: Drive just drives, and Avoid takes
// over from it while a bumper is pressed. The arbitrator chooses: the
// later a behaviour stands in the array, the more important it is.
// Next: add a behaviour that beeps whenever it gets dark.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class BouncerWithBehaviours {
    public static void main(String[] args) {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Behavior[] behaviors = {
            new Drive(),
            new Avoid(Sensor.S1, Motor.A), // left
            new Avoid(Sensor.S3, Motor.C), // right
        };
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
            // The motors soon get another command.
        }
    }

    static class Avoid implements Behavior {
        private final Sensor bumper;
        private final Motor near;
        private boolean isSuppressed;

        Avoid(Sensor bumper, Motor near) {
            this.bumper = bumper;
            this.near = near;
        }

        public boolean takeControl() {
            return bumper.readBooleanValue();
        }

        public void action() {
            isSuppressed = false;
            Motor.A.backward();
            Motor.C.backward();
            pause(250);
            near.forward();
            pause(350);
        }

        public void suppress() {
            isSuppressed = true;
        }

        /** Lets time pass, but no longer than this behaviour has the robot. */
        private void pause(int milliseconds) {
            int end = (int) System.currentTimeMillis() + milliseconds;
            while (!isSuppressed && end - (int) System.currentTimeMillis() > 0) Thread.yield();
        }
    }
}
