// mode: brick
import josx.platform.rcx.Button;
import josx.platform.rcx.ButtonListener;
import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.SensorListener;

/** Until a program uses a sensor, a brick has raw values, so that the first mode is a change. */
public class SensorsAreRawAtFirst implements ButtonListener, SensorListener {
    public static void main(String[] arguments) throws InterruptedException {
        SensorsAreRawAtFirst listener = new SensorsAreRawAtFirst();
        Button.VIEW.addButtonListener(listener);
        Sensor.S1.setTypeAndMode(1, 0x20);
        Sensor.S1.addSensorListener(listener);
        Thread.sleep(300);
    }

    public void buttonPressed(Button button) {
    }

    public void buttonReleased(Button button) {
    }

    public void stateChanged(Sensor source, int oldValue, int newValue) {
        LCD.showNumber(1000 + oldValue * 10 + newValue); // shows: 1000
    }
}
// ends at 300
