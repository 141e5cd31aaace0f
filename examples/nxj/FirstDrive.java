// Drives forward for two seconds.
// Next: let it drive back again.

import lejos.nxt.*;
import lejos.util.Delay;

public class FirstDrive {
    public static void main(String[] args) {
        Motor.A.forward();
        Motor.C.forward();
        Delay.msDelay(2000);
        Motor.A.stop(true);
        Motor.C.stop();
    }
}
