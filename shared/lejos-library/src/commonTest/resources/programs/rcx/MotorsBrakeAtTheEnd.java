import josx.platform.rcx.Motor;

public class MotorsBrakeAtTheEnd {
    public static void main(String[] arguments) throws InterruptedException {
        Motor.A.forward(); // rom: 0x1a4e 0x2000 1 3
        Thread.sleep(300);
    }
}
// ends at 300
