import lejos.geom.Point;
import lejos.robotics.localization.BeaconTriangle;
import lejos.robotics.navigation.Pose;

/** Three beacons tell where a robot is. */
public class Beacons {
    static final Point[] places = {new Point(100, 0), new Point(100, 100), new Point(0, 50)};

    static double seen(Pose robot, int i) {
        double angle = robot.relativeBearing(places[i]);
        return angle < 0 ? angle + 360 : angle;
    }

    static void show(float x, float y, float heading) {
        Pose robot = new Pose(x, y, heading);
        Pose found = new BeaconTriangle(places[0], places[1], places[2]).calcPose(seen(robot, 0), seen(robot, 1), seen(robot, 2));
        System.out.println(Math.round(found.getX()) + " " + Math.round(found.getY()) + " " + Math.round(found.getHeading()));
    }

    public static void main(String[] arguments) {
        show(60, 40, 0); // expect 60 40 0
        show(60, 40, 70); // expect 60 40 70
        show(80, 60, -120); // expect 80 60 -120
    }
}
