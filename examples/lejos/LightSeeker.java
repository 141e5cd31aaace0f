// Turns once round, remembers where it is brightest, and drives there.
// Its light sensor has to look forward.
// Next: let it flee from the light.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;

public class LightSeeker {
    static final int LOOKS = 12; // in a full turn
    static final int LOOK_MILLISECONDS = 360 / LOOKS * 5;

    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(50); // until it has measured
        int best = 0;
        int bestLight = 0;
        for (int look = 0; look < LOOKS; look++) {
            int light = Sensor.S2.readValue();
            if (light > bestLight) {
                bestLight = light;
                best = look;
            }
            turnLeft(1);
        }
        LCD.showNumber(bestLight);
        turnLeft(best);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2000);
    }

    static void turnLeft(int looks) throws InterruptedException {
        Motor.A.backward();
        Motor.C.forward();
        Thread.sleep(looks * LOOK_MILLISECONDS);
        Motor.A.stop();
        Motor.C.stop();
    }
}
