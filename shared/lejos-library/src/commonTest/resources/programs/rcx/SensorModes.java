import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

public class SensorModes {
    static void read(int mode) throws InterruptedException {
        Sensor.S3.setTypeAndMode(SensorConstants.SENSOR_TYPE_RAW, mode);
        Thread.sleep(20);
        LCD.showNumber(Sensor.S3.readValue()); // shows: 609 66 200 680 0
    }

    public static void main(String[] arguments) throws InterruptedException {
        read(SensorConstants.SENSOR_MODE_RAW);
        read(SensorConstants.SENSOR_MODE_PCT);
        read(SensorConstants.SENSOR_MODE_DEGC);
        read(SensorConstants.SENSOR_MODE_DEGF);
        read(SensorConstants.SENSOR_MODE_BOOL);
        LCD.showNumber(Sensor.readSensorValue(2, SensorConstants.RAW_VALUE)); // shows: 609
        LCD.showNumber(Sensor.readSensorValue(2, SensorConstants.CANONICAL_VALUE)); // shows: 0
        LCD.showNumber(Sensor.readSensorValue(2, SensorConstants.BOOLEAN_VALUE)); // shows: 0
    }
}
// sensor 3 at 0: raw 609
