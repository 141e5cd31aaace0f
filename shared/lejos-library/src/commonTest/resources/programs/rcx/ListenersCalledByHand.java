import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorListener;
import josx.platform.rcx.Serial;

public class ListenersCalledByHand {
    static int calls = 0;

    public static void main(String[] arguments) {
        SensorListener listener = new SensorListener() {
            public void stateChanged(Sensor source, int oldValue, int newValue) {
                calls++;
            }
        };
        Sensor.S3.addSensorListener(listener);
        Sensor.S3.addSensorListener(listener);
        calls = 0;
        Sensor.S3.callListeners();
        LCD.showNumber(calls); // shows: 2
        LCD.showNumber(Serial.isSending() ? 1 : 0); // shows: 0
    }
}
