import lejos.nxt.Motor;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.SteeringPilot;

/** A pilot steers with one motor and drives with the other. */
public class SteeredCar {
    static volatile int moves;

    static void show(String what) throws InterruptedException {
        while (moves == 0) Thread.sleep(5);
        moves = 0;
        System.out.println(what + " " + Math.round(Motor.A.getTachoCount() / 10.0) + " " + Motor.B.getTachoCount());
    }

    public static void main(String[] arguments) throws Exception {
        SteeringPilot pilot = new SteeringPilot(5.6, Motor.A, Motor.B, 30, 40, -40);
        pilot.addMoveListener(new MoveListener() {
            public void moveStarted(Move move, MoveProvider provider) {
            }

            public void moveStopped(Move move, MoveProvider provider) {
                System.out.println(move.getMoveType() + " " + Math.round(move.getDistanceTraveled()) + " " + Math.round(move.getAngleTurned()));
                moves++;
            }
        });
        pilot.travel(17.6);
        show("straight on"); // expect TRAVEL 18 0
        // expect straight on 36 0
        pilot.arc(30, 45);
        show("left"); // expect ARC 24 45
        // expect left 84 40
        pilot.travelArc(-30, 10, false);
        show("right"); // expect ARC 10 -19
        // expect right 105 -40
        pilot.backward();
        Thread.sleep(500);
        pilot.stop(); // expect TRAVEL -9 0
        System.out.println(Motor.A.getTachoCount() < 1050 && Motor.B.getTachoCount() == 0); // expect true
        try {
            pilot.arc(10, 90);
        } catch (IllegalArgumentException e) {
            System.out.println(e.getMessage()); // expect Turn radius can't be less than 30.0
        }
    }
}
