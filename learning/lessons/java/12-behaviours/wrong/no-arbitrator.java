// hint: line missing
import josx.platform.rcx.*;
import josx.robotics.*;

public class Patrol {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Behavior[] behaviors = {
            new Drive(),
            new Avoid(Sensor.S1, Motor.A),
            new Avoid(Sensor.S3, Motor.C),
        };
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

        Avoid(Sensor bumper, Motor near) {
            this.bumper = bumper;
            this.near = near;
        }

        public boolean takeControl() {
            return bumper.readBooleanValue();
        }

        public void action() {
            Motor.A.backward();
            Motor.C.backward();
            pause(250);
            near.forward();
            pause(100);
        }

        public void suppress() {
            // It is over soon.
        }
    }

    static void pause(int milliseconds) {
        try {
            Thread.sleep(milliseconds);
        } catch (InterruptedException enough) {
            Thread.currentThread().interrupt();
        }
    }
}
