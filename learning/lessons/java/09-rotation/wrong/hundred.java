// hint: wrong number
import josx.platform.rcx.*;

public class Counts {
    public static void main(String[] args) throws InterruptedException {
        prepare(Sensor.S1);
        prepare(Sensor.S3);
        Motor.A.forward();
        Motor.C.forward();
        while (Sensor.S1.readValue() < 110) {
            Thread.sleep(5);
        }
        Motor.A.stop();
        Motor.C.stop();
    }

    static void prepare(Sensor sensor) {
        sensor.setTypeAndMode(SensorConstants.SENSOR_TYPE_ROT, SensorConstants.SENSOR_MODE_ANGLE);
        sensor.activate();
        sensor.setPreviousValue(0);
    }
}
