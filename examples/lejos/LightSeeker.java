import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;
import josx.platform.rcx.Sensor;

/** Turns once around, remembers where it is brightest, and drives there. */
public class LightSeeker {
    static final int STEPS = 18;
    static final int STEP_MILLISECONDS = 100;

    public static void main(String[] arguments) throws InterruptedException {
        Sensor.S2.activate();
        Thread.sleep(50);
        int brightest = 0;
        int direction = 0;
        for (int step = 0; step < STEPS; step++) {
            int light = Sensor.S2.readValue();
            if (light > brightest) {
                brightest = light;
                direction = step;
            }
            turn(1);
        }
        LCD.showNumber(brightest);
        turn(direction);
        Motor.A.forward();
        Motor.C.forward();
        Thread.sleep(2000);
        Motor.A.stop();
        Motor.C.stop();
    }

    static void turn(int steps) throws InterruptedException {
        Motor.A.backward();
        Motor.C.forward();
        Thread.sleep(steps * STEP_MILLISECONDS);
        Motor.A.stop();
        Motor.C.stop();
    }
}
