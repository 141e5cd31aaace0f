import josx.platform.rcx.*;

public class Dan {
    public static void main(String[] args) throws Exception {
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(4200);
        Motor.A.stop();
        Motor.C.stop();
    }
}
