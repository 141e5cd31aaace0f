import josx.platform.rcx.LCD;
import josx.platform.rcx.ProximitySensor;
import josx.platform.rcx.Sensor;

public class Proximity {
    public static void main(String[] arguments) throws InterruptedException {
        ProximitySensor eye = new ProximitySensor(Sensor.S2, 10);
        eye.waitTillNear(0);
        LCD.showNumber((int) System.currentTimeMillis() >= 500 ? 1 : 0); // shows: 1
        eye.waitTillNear(100);
        ProximitySensor other = new ProximitySensor(Sensor.S1);
        other.stateChanged(Sensor.S1, 0, 100);
        LCD.showNumber((int) System.currentTimeMillis() >= 600 ? 1 : 0); // shows: 1
    }
}
// sensor 2 at 0: raw 1023
// sensor 2 at 500: raw 700
