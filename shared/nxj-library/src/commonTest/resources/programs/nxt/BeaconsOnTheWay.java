import java.util.ArrayList;
import lejos.geom.Point;
import lejos.nxt.Motor;
import lejos.robotics.localization.BeaconLocator;
import lejos.robotics.localization.BeaconPoseProvider;
import lejos.robotics.localization.BeaconTriangle;
import lejos.robotics.navigation.DifferentialPilot;
import lejos.robotics.navigation.Pose;

/** A robot looks for beacons after every other move, and counts its moves in between. */
public class BeaconsOnTheWay {
    static final Point[] places = {new Point(100, 0), new Point(100, 100), new Point(0, 50)};
    static Pose robot = new Pose(60, 40, 90);
    static int looks;

    static void show(BeaconPoseProvider provider) {
        Pose pose = provider.getPose();
        System.out.println(looks + ": " + Math.round(pose.getX()) + " " + Math.round(pose.getY()) + " " + Math.round(pose.getHeading()));
    }

    public static void main(String[] arguments) {
        BeaconLocator locator = new BeaconLocator() {
            public ArrayList<Double> locate() {
                looks++;
                ArrayList<Double> angles = new ArrayList<Double>();
                for (int i = 0; i < places.length; i++) {
                    double angle = robot.relativeBearing(places[i]);
                    angles.add(angle < 0 ? angle + 360 : angle);
                }
                return angles;
            }
        };
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11, Motor.A, Motor.C);
        BeaconTriangle triangle = new BeaconTriangle(places[0], places[1], places[2]);
        BeaconPoseProvider provider = new BeaconPoseProvider(locator, triangle, pilot, 2);
        show(provider);
        // expect POSE CALC
        // expect 60.0, 40.0
        // expect H: 90.0
        // expect set to true
        // expect 1: 60 40 90
        pilot.travel(10);
        show(provider); // expect 1: 60 50 90
        pilot.travel(-10);
        robot = new Pose(62, 41, 90);
        show(provider);
        // expect AFTER SORT:
        // expect a0: 222.825256347656
        // expect a1: 327.215717315674
        // expect a2: 81.7405548095703
        // expect POSE CALC
        // expect 62.0, 41.0
        // expect H: 90.00002
        // expect set to true
        // expect 2: 62 41 90
        System.exit(0);
    }
}
