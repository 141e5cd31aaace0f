import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Square {
    public static void main(String[] args) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        Motor.B.rotateTo(90);   // pen down
        for (int side = 1; side <= 2; side++) {
            pilot.travel(20);
            pilot.rotate(90);
        }
    }
}
