// Draws a square with a pilot, 20 cm wide.
// Next: make it a triangle.

import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Square {
    public static void main(String[] args) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        pilot.setRotateSpeed(90);
        Motor.B.rotateTo(85);
        for (int side = 0; side < 4; side++) {
            pilot.travel(20);
            pilot.rotate(90);
        }
        Motor.B.rotateTo(0);
    }
}
