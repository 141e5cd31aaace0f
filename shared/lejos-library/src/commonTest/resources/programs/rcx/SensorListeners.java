import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorListener;

public class SensorListeners {
    public static void main(String[] arguments) throws InterruptedException {
        Thread.sleep(100);
        Sensor.S2.addSensorListener(new SensorListener() {
            public void stateChanged(Sensor source, int oldValue, int newValue) {
                LCD.showNumber(source.getId() * 1000 + newValue - oldValue); // shows: 1067 1016
            }
        });
        Thread.sleep(500);
    }
}
// sensor 2 at 200: raw 600
// sensor 2 at 300: raw 500
// ends at 600
