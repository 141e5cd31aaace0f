// Shows how bright it is and plays a tone that rises with the light.
// Next: draw dots where it is dark.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sensor;
import josx.platform.rcx.Sound;

public class LightMeter {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        while (true) {
            int light = Sensor.S2.readValue();
            LCD.showNumber(light);
            Sound.playTone(200 + light * 10, 10);
            Thread.sleep(300);
        }
    }
}
