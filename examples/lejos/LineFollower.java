import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;

/** Follows the left edge of a dark line with the light sensor, which faces down. */
public class LineFollower {
    static final int EDGE = 42;

    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(50);
        while (true) {
            int light = Sensor.S2.readValue();
            if (light > EDGE) {
                Motor.A.forward();
                Motor.C.stop();
            } else {
                Motor.A.stop();
                Motor.C.forward();
            }
            LCD.showNumber(light);
            Thread.sleep(10);
        }
    }
}
