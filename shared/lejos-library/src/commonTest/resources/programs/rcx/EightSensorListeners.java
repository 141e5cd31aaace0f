import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorListener;

public class EightSensorListeners implements SensorListener {
    public void stateChanged(Sensor source, int oldValue, int newValue) {
    }

    public static void main(String[] arguments) {
        EightSensorListeners listener = new EightSensorListeners();
        for (int count = 0; count < 8; count++) Sensor.S1.addSensorListener(listener);
        try {
            Sensor.S1.addSensorListener(listener);
        } catch (ArrayIndexOutOfBoundsException tooMany) {
            LCD.showNumber(9); // shows: 9
        }
    }
}
