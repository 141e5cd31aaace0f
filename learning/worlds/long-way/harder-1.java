// Counts how far both wheels have turned, forwards and backwards. The wheel that is ahead waits.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

class LongWay {
    /** A wheel is 15.6 cm round, and its sensor counts 16 for a turn. */
    static final int COUNTS = 150 * 160 / 156;

    public static void main(String[] args) throws InterruptedException {
        prepare(Sensor.S1);
        prepare(Sensor.S3);
        while (left() + right() < 2 * COUNTS) {
            if (left() <= right()) Motor.A.forward(); else Motor.A.stop();
            if (right() <= left()) Motor.C.forward(); else Motor.C.stop();
            Thread.sleep(5);
        }
        halt();
        while (left() + right() > 0) {
            if (left() >= right()) Motor.A.backward(); else Motor.A.stop();
            if (right() >= left()) Motor.C.backward(); else Motor.C.stop();
            Thread.sleep(5);
        }
        halt();
    }

    static int left() {
        return Sensor.S1.readValue();
    }

    static int right() {
        return Sensor.S3.readValue();
    }

    static void halt() throws InterruptedException {
        Motor.A.stop();
        Motor.C.stop();
        Thread.sleep(500);
    }

    static void prepare(Sensor sensor) {
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.activate();
        sensor.setPreviousValue(0);
    }
}
