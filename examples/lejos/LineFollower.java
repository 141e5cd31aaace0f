// Follows the left edge of a dark line; the light sensor looks down.
// It always drives a curve: to the left on the line, to the right off it.
// Next: follow the right edge.

import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;

public class LineFollower {
    static final int BORDER = 45; // dark is below

    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(50); // until it has measured
        while (true) {
            if (Sensor.S2.readValue() < BORDER) {
                Motor.A.stop();
                Motor.C.forward();
            } else {
                Motor.A.forward();
                Motor.C.stop();
            }
            Thread.sleep(10);
        }
    }
}
