import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class ArbitratorChooses {
    static class Drive implements Behavior {
        public boolean takeControl() {
            return true;
        }

        public void action() {
            Motor.A.forward(); // rom 2 times: 0x1a4e 0x2000 1 3
        }

        public void suppress() {
            Motor.A.flt(); // rom 2 times: 0x1a4e 0x2000 4 3
        }
    }

    static class Retreat implements Behavior {
        public boolean takeControl() {
            return Sensor.S1.readBooleanValue();
        }

        public void action() {
            Motor.A.backward(); // rom: 0x1a4e 0x2000 2 3
            try {
                Thread.sleep(200);
            } catch (InterruptedException never) {
                LCD.clear();
            }
            Motor.A.stop(); // rom: 0x1a4e 0x2000 3 7
        }

        public void suppress() {
            Motor.C.flt(); // rom: 0x1a4e 0x2002 4 3
        }
    }

    static class TheEnd implements Behavior {
        public boolean takeControl() {
            return (int) System.currentTimeMillis() > 1000;
        }

        public void action() {
            System.exit(0);
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Behavior[] behaviors = {new Drive(), new Retreat(), new TheEnd()};
        new Arbitrator(behaviors).start();
    }
}
// sensor 1 at 300: raw 20
// sensor 1 at 400: raw 1023
// ends at 1001
