import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorListener;

/** A listener is not told what a sensor has measured before, but the first old value is 0. */
public class SensorsChangeFromNow {
    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(100);
        Sensor.S2.addSensorListener(new SensorListener() {
            public void stateChanged(Sensor source, int oldValue, int newValue) {
                LCD.showNumber(oldValue * 100 + newValue); // brick shows: 83 // forgiving shows: 67 6783
            }
        });
        Thread.sleep(300);
    }
}
// sensor 2 at 0: raw 600
// sensor 2 at 300: raw 500
// ends at 400
