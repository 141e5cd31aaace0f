// line-and-walls.robo, translated by Robotran for leJOS on the RCX.

import josx.platform.rcx.*;

public class LineAndWalls {
    static int turns = 0;

    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        // It looks at the paper.
        Sensor.S2.activate();

        while (!(turns >= 10 || Button.PRGM.isPressed())) {
            if (Sensor.S1.readBooleanValue() && Sensor.S3.readBooleanValue()) {
                backwardSeconds(1);
            } else if (Sensor.S2.readValue() < 40) {
                Motor.A.flt();
                Motor.C.forward();
                turns = turns + 1;
            } else {
                Motor.A.forward();
                Motor.C.forward();
            }
            while (Sensor.S1.readBooleanValue() || Sensor.S2.readValue() == 50) Thread.sleep(1);
        }
        power(7);
        System.exit(0);
    }

    // The methods below do what the commands of Robolang do.

    /** The nearest whole number, a half upwards. */
    static int roundHalfUp(float value) {
        int below = (int) value;
        return value - below >= 0.5f && below < 2147483647 ? below + 1 : below;
    }

    /** Lets the wheels turn for a while, then stops them. */
    static void stopAfter(float milliseconds) throws InterruptedException {
        Thread.sleep(roundHalfUp(milliseconds < 0 ? -milliseconds : milliseconds));
        Motor.A.stop();
        Motor.C.stop();
    }

    /** Drives back for a while. */
    static void backwardSeconds(float seconds) throws InterruptedException {
        Motor.A.backward();
        Motor.C.backward();
        stopAfter(seconds * 1000);
    }

    /** Sets how strongly both wheels turn, 0 to 7. */
    static void power(int power) {
        Motor.A.setPower(power);
        Motor.C.setPower(power);
    }
}
