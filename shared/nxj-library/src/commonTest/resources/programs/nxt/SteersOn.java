import lejos.nxt.Motor;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;

/** Steering on in another curve is the same move; anything else is a new one. */
public class SteersOn {
    private static final StringBuilder LOG = new StringBuilder();

    static String told() {
        String told = LOG.toString();
        LOG.setLength(0);
        return told;
    }

    public static void main(String[] arguments) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        pilot.addMoveListener(new MoveListener() {
            public void moveStarted(Move move, MoveProvider provider) {
                LOG.append('<');
            }

            public void moveStopped(Move move, MoveProvider provider) {
                LOG.append('>');
            }
        });
        pilot.setTravelSpeed(12);
        int turns = 0;
        for (int rate = 20; pilot.getMovement().getDistanceTraveled() < 15 && turns < 100; rate = -rate) {
            pilot.steer(rate);
            turns++;
            Thread.sleep(50);
        }
        System.out.println(turns < 50); // expect true
        pilot.stop();
        System.out.println(told()); // expect <>
        pilot.steerBackward(30);
        Thread.sleep(300);
        float way = pilot.getMovementIncrement();
        pilot.steerBackward(-30);
        Thread.sleep(300);
        System.out.println(pilot.getMovementIncrement() < way - 1); // expect true
        System.out.println(told()); // expect <
        pilot.steer(0);
        Thread.sleep(100);
        pilot.arcForward(30);
        pilot.arcForward(20);
        pilot.stop();
        System.out.println(told()); // expect ><><><>
    }
}
