import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.Sound;
import lejos.nxt.TouchSensor;
import lejos.nxt.UltrasonicSensor;

/** Drives until something is near, then turns away. */
public class Wanderer {
    public static void main(String[] arguments) throws InterruptedException {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        TouchSensor left = new TouchSensor(SensorPort.S1);
        TouchSensor right = new TouchSensor(SensorPort.S2);
        Motor.A.setSpeed(400);
        Motor.C.setSpeed(400);
        for (int turns = 0; turns < 8; turns++) {
            Motor.A.forward();
            Motor.C.forward();
            int distance = 255;
            while (distance > 20 && !left.isPressed() && !right.isPressed()) {
                distance = sonar.getDistance();
                LCD.drawInt(distance, 3, 0, turns);
            }
            Motor.A.stop(true);
            Motor.C.stop();
            Sound.playTone(800, 50);
            Motor.A.rotate(-180, true);
            Motor.C.rotate(-180);
            Motor.A.rotate(200, true);
            Motor.C.rotate(-200);
        }
        LCD.refresh();
    }
}
