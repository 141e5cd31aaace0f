import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;

public class SensorsBegin {
    public static void main(String[] arguments) throws InterruptedException {
        Thread.sleep(10);
        LCD.showNumber(Sensor.S1.readValue()); // shows: 67
        LCD.showNumber(Sensor.S1.readRawValue()); // shows: 600
        LCD.showNumber(Sensor.S2.readValue()); // shows: 0
        LCD.showNumber(Sensor.S2.getId()); // shows: 1
        LCD.showNumber(Sensor.SENSORS[2] == Sensor.S3 ? 1 : 0); // shows: 1
        LCD.showNumber(Sensor.SENSORS.length); // shows: 3
    }
}
// sensor 1 at 0: raw 600
