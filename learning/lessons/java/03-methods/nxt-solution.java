import lejos.nxt.*;
import lejos.robotics.navigation.DifferentialPilot;

public class Squares {
    static DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);

    public static void main(String[] args) {
        Motor.B.rotateTo(90);   // pen down
        square(20);
        square(10);
        Motor.B.rotateTo(0);    // pen up
    }

    static void square(int length) {
        for (int side = 1; side <= 4; side++) {
            pilot.travel(length);
            pilot.rotate(90);
        }
    }
}
