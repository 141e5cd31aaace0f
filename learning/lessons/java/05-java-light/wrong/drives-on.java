// hint: line too many
import josx.platform.rcx.*;

public class Edge {
    public static void main(String[] args) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(100);
        Motor.A.forward();
        Motor.C.forward();
        while (Sensor.S2.readValue() > 40) {
            Thread.sleep(5);
        }
        Motor.A.stop();
        Motor.C.stop();
        Sound.beep();
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(500);
    }
}
