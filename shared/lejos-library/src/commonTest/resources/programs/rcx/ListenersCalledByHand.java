import josx.platform.rcx.Button;
import josx.platform.rcx.ButtonListener;
import josx.platform.rcx.LCD;
import josx.platform.rcx.ListenerCaller;
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
        Button.VIEW.addButtonListener(new ButtonListener() {
            public void buttonPressed(Button button) {
                calls += 10;
            }

            public void buttonReleased(Button button) {
                calls += 100;
            }
        });
        Button.VIEW.callListeners();
        LCD.showNumber(calls); // shows: 102
        ListenerCaller[] callers = {Sensor.S1, Sensor.S3, Button.RUN, Button.VIEW};
        for (int index = 0; index < callers.length; index++) callers[index].callListeners();
        LCD.showNumber(calls); // shows: 204
        LCD.showNumber(Serial.isSending() ? 1 : 0); // shows: 0
    }
}
