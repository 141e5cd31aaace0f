// Drives forward for two seconds. Each motor is told to turn, and
// goes on turning until it is told to stop.
// Next: let it drive back to where it began.

import josx.platform.rcx.Motor;

public class FirstDrive {
    public static void main(String[] args) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2000);
        Motor.A.stop();
        Motor.C.stop();
    }
}
