import lejos.nxt.Button;
import lejos.nxt.LightSensor;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;

/** Follows the left edge of a dark line, the more to one side the brighter or darker it is. */
public class FollowLine {
    public static void main(String[] arguments) throws InterruptedException {
        LightSensor light = new LightSensor(SensorPort.S3);
        Motor.A.forward();
        Motor.C.forward();
        while (!Button.ESCAPE.isPressed()) {
            int error = light.getLightValue() - 45;
            Motor.A.setSpeed(Math.max(20, 200 + 15 * error));
            Motor.C.setSpeed(Math.max(20, 200 - 15 * error));
            Thread.sleep(20);
        }
    }
}
