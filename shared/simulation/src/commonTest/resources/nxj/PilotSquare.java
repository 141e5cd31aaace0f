import lejos.nxt.Motor;
import lejos.robotics.navigation.DifferentialPilot;

/** Draws a square of 20 centimetres. */
public class PilotSquare {
    public static void main(String[] arguments) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.setTravelSpeed(15);
        pilot.setRotateSpeed(90);
        Motor.B.rotateTo(90);
        for (int side = 0; side < 4; side++) {
            pilot.travel(20);
            pilot.rotate(90);
        }
        Motor.B.rotateTo(0);
    }
}
