import josx.platform.rcx.Motor;

/** Drives forward for two seconds. */
public class FirstDrive {
    public static void main(String[] arguments) throws InterruptedException {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2000);
        Motor.A.stop();
        Motor.C.stop();
    }
}
