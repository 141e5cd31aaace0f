import josx.platform.rcx.*;

public class Cem {
    public static void main(String[] args) throws Exception {
        Motor.A.setPower(7);
        Motor.C.setPower(7);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(4200);
        Motor.A.stop();
        Motor.C.stop();
    }
}
