// Drives ahead until a bumper is pressed, goes back and turns away; ESCAPE ends.
// Next: use the ultrasonic sensor, so that it turns before it bumps.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class WallBouncer {
    public static void main(String[] args) {
        TouchSensor left = new TouchSensor(SensorPort.S1);
        TouchSensor right = new TouchSensor(SensorPort.S2);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(20);
        while (!Button.ESCAPE.isDown()) {
            pilot.forward();
            if (left.isPressed()) {
                pilot.travel(-10);
                pilot.rotate(-60);
            } else if (right.isPressed()) {
                pilot.travel(-10);
                pilot.rotate(60);
            }
        }
        pilot.stop();
    }
}
