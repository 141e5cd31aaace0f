// Counts how far both wheels have turned, in the corner as well: there one wheel turns backwards.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

class LongWay {
    /** In a turn of 90 degrees each wheel goes a quarter of a circle of 11.5 cm: 9 cm. */
    static final int CORNER = 9;

    public static void main(String[] args) throws InterruptedException {
        prepare(Sensor.S1);
        prepare(Sensor.S3);
        drive(80);
        turnLeft();
        drive(60);
    }

    /** A wheel is 15.6 cm round, and its sensor counts 16 for a turn. */
    static int counts(int centimetres) {
        return centimetres * 160 / 156;
    }

    static void drive(int centimetres) throws InterruptedException {
        reset();
        while (left() + right() < 2 * counts(centimetres)) {
            if (left() <= right()) Motor.A.forward(); else Motor.A.stop();
            if (right() <= left()) Motor.C.forward(); else Motor.C.stop();
            Thread.sleep(5);
        }
        halt();
    }

    static void turnLeft() throws InterruptedException {
        reset();
        while (right() - left() < 2 * counts(CORNER)) {
            if (-left() <= right()) Motor.A.backward(); else Motor.A.stop();
            if (right() <= -left()) Motor.C.forward(); else Motor.C.stop();
            Thread.sleep(5);
        }
        halt();
    }

    static void halt() throws InterruptedException {
        Motor.A.stop();
        Motor.C.stop();
        Thread.sleep(500);
    }

    static int left() {
        return Sensor.S1.readValue();
    }

    static int right() {
        return Sensor.S3.readValue();
    }

    static void reset() {
        Sensor.S1.setPreviousValue(0);
        Sensor.S3.setPreviousValue(0);
    }

    static void prepare(Sensor sensor) {
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.activate();
    }
}
