import lejos.nxt.Motor;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.NavigationListener;
import lejos.robotics.navigation.Navigator;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;

/** A robot on its way does not turn; points are counted from 1, and one where it was stopped does not count. */
public class NavigatorOnTheWay implements NavigationListener {
    public static void main(String[] arguments) throws InterruptedException {
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        Navigator navigator = new Navigator(pilot);
        navigator.addNavigationListener(new NavigatorOnTheWay());
        navigator.goTo(10, 0);
        navigator.addWaypoint(40, 0);
        System.out.println(navigator.rotateTo(90) + " " + navigator.isMoving()); // expect false true
        while (navigator.getWaypoint().x < 20) Thread.sleep(20); // expect at 1 10
        Thread.sleep(300);
        navigator.stop(); // expect cut 1 40
        System.out.println(navigator.isMoving() + " " + navigator.pathCompleted()); // expect false false
        System.out.println(navigator.rotateTo(90)); // expect true
        System.out.println(Math.round(navigator.getPoseProvider().getPose().getHeading() / 2)); // expect 45
        navigator.followPath();
        System.out.println(navigator.waitForStop()); // expect at 2 40
        // expect done 2 40
        // expect true
    }

    public void atWaypoint(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("at " + sequence + " " + (int) waypoint.x);
    }

    public void pathComplete(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("done " + sequence + " " + (int) waypoint.x);
    }

    public void pathInterrupted(Waypoint waypoint, Pose pose, int sequence) {
        System.out.println("cut " + sequence + " " + (int) waypoint.x);
    }
}
