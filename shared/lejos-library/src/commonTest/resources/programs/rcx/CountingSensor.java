import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorConstants;

public class CountingSensor {
    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S1.setTypeAndMode(SensorConstants.SENSOR_TYPE_TOUCH, SensorConstants.SENSOR_MODE_PULSE);
        Thread.sleep(100);
        Sensor.S1.setPreviousValue(5);
        Thread.sleep(2900);
        LCD.showNumber(Sensor.S1.readValue()); // shows: 7
    }
}
// sensor 1 at 500: raw 20
// sensor 1 at 1000: raw 1023
// sensor 1 at 1500: raw 20
// sensor 1 at 2000: raw 1023
// ends at 3000
