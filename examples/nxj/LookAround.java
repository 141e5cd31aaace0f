// Looks all around and then turns to what is nearest.
// Next: let it drive there and stop in front of it.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.util.Delay;

public class LookAround {
    static final int STEP = 15;

    public static void main(String[] args) {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setRotateSpeed(90);
        int nearest = 255;
        int direction = 0;
        for (int angle = 0; angle < 360; angle += STEP) {
            Delay.msDelay(100);
            int distance = sonar.getDistance();
            if (distance < nearest) {
                nearest = distance;
                direction = angle;
            }
            pilot.rotate(STEP);
        }
        if (direction > 180) direction -= 360;
        pilot.rotate(direction);
        LCD.drawString("Nearest: " + nearest, 0, 0);
        Sound.beep();
        Delay.msDelay(1000);
    }
}
