// hint: wrong number
// Counts how far both wheels have turned. The wheel that is ahead waits for the other, so the robot drives straight.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

class LongWay {
    /** A wheel is 15.6 cm round, and its sensor counts 16 for a turn. */
    static final int COUNTS = 165 * 160 / 156;

    public static void main(String[] args) throws InterruptedException {
        prepare(Sensor.S1);
        prepare(Sensor.S3);
        int left = 0;
        int right = 0;
        while (left + right < 2 * COUNTS) {
            drive(Motor.A, left <= right);
            drive(Motor.C, right <= left);
            Thread.sleep(5);
            left = Sensor.S1.readValue();
            right = Sensor.S3.readValue();
        }
        Motor.A.stop();
        Motor.C.stop();
        LCD.showNumber(left);
    }

    static void prepare(Sensor sensor) {
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.activate();
        sensor.setPreviousValue(0);
    }

    static void drive(Motor motor, boolean on) {
        if (on) motor.forward();
        else motor.stop();
    }
}
