import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

public class TouchSensor {
    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_BOOL);
        Thread.sleep(50);
        LCD.showNumber(Sensor.S1.readBooleanValue() ? 1 : 0); // shows: 0
        Thread.sleep(100);
        LCD.showNumber(Sensor.S1.readBooleanValue() ? 1 : 0); // shows: 1
        LCD.showNumber(Sensor.S1.readValue()); // shows: 1
        Thread.sleep(100);
        LCD.showNumber(Sensor.S1.readValue()); // shows: 0
    }
}
// sensor 1 at 100: raw 20
// sensor 1 at 200: raw 1023
// ends at 250
