import josx.platform.rcx.*;

public class Edge {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(100);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(1000);
        Motor.A.stop();
        Motor.C.stop();
        Sound.beep();
        Thread.sleep(500);
    }
}
