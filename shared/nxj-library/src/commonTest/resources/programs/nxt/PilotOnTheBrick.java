import lejos.nxt.Motor;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;

/** A pilot with the motors of the brick. */
public class PilotOnTheBrick {
    public static void main(String[] arguments) {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.2, Motor.A, Motor.C);
        final StringBuilder log = new StringBuilder();
        pilot.addMoveListener(new MoveListener() {
            public void moveStarted(Move move, MoveProvider provider) {
                log.append('<');
            }

            public void moveStopped(Move move, MoveProvider provider) {
                log.append(Math.round(move.getDistanceTraveled())).append('>');
            }
        });
        pilot.setTravelSpeed(15);
        pilot.travel(20);
        System.out.println(Math.abs(Motor.A.getTachoCount() - 409) < 3); // expect true
        System.out.println(Math.abs(Motor.C.getTachoCount() - 409) < 3); // expect true
        System.out.println(log); // expect <20>
        pilot.rotate(90);
        System.out.println(Math.abs(Motor.A.getTachoCount() - 229) < 4); // expect true
        System.out.println(Math.round(pilot.getAngleIncrement() / 2) * 2); // expect 90
        pilot.travel(100, true);
        while (pilot.isMoving()) {
            if (pilot.getMovementIncrement() > 10) pilot.stop();
        }
        float way = pilot.getMovementIncrement();
        System.out.println(way > 10 && way < 13); // expect true
        pilot.forward();
        pilot.quickStop();
        System.out.println(pilot.isMoving() + " " + pilot.isStalled()); // expect false false
    }
}
