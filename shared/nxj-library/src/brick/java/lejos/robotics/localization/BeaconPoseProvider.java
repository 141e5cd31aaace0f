package lejos.robotics.localization;

import java.util.ArrayList;
import lejos.nxt.Sound;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.MoveListener;
import lejos.robotics.navigation.MoveProvider;
import lejos.robotics.navigation.Pose;

/**
 * Knows where a robot is from three beacons, and in between from its moves.
 *
 * <p>At the start, the robot looks at beacon 2, with beacon 1 on its right and beacon 3 on its left. If it does not see
 * three beacons, it buzzes. As in leJOS NXJ, it writes what it finds on the display.
 */
public class BeaconPoseProvider implements PoseProvider, MoveListener {
    private static final int USUAL_INTERVAL = 5;
    private static final int BEACONS = 3;

    private final BeaconLocator locator;
    private final BeaconTriangle triangle;
    private final OdometryPoseProvider odometry;
    private final int interval;
    private int moves;
    private boolean hasFound;

    /** Makes one that looks for the beacons after every five moves. */
    public BeaconPoseProvider(BeaconLocator bl, BeaconTriangle bt, MoveProvider mp) {
        this(bl, bt, mp, USUAL_INTERVAL);
    }

    /** Makes one that looks for the beacons after so many moves. */
    public BeaconPoseProvider(BeaconLocator bl, BeaconTriangle bt, MoveProvider mp, int scanInterval) {
        locator = bl;
        triangle = bt;
        odometry = new OdometryPoseProvider(mp);
        mp.addMoveListener(this);
        interval = scanInterval;
        moves = scanInterval;
    }

    /** Gives where the robot is; if it has moved often enough, it looks for the beacons. */
    public Pose getPose() {
        if (moves < interval) return odometry.getPose();
        ArrayList<Double> seen = locator.locate();
        if (seen.size() != BEACONS) {
            Sound.buzz();
            return odometry.getPose();
        }
        if (hasFound) {
            sort(seen, expected());
            System.out.println("AFTER SORT:");
            for (int i = 0; i < BEACONS; i++) System.out.println("a" + i + ": " + seen.get(i));
        }
        Pose pose = triangle.calcPose(seen.get(0), seen.get(1), seen.get(2));
        System.out.println("POSE CALC");
        System.out.println(pose.getX() + ", " + pose.getY());
        System.out.println("H: " + pose.getHeading());
        odometry.setPose(pose);
        moves = 0;
        hasFound = true;
        System.out.println("set to " + hasFound);
        return pose;
    }

    /** In which directions the beacons should be after the moves. */
    private ArrayList<Double> expected() {
        Pose robot = odometry.getPose();
        ArrayList<Double> angles = new ArrayList<Double>();
        angles.add(toTheLeft(robot, robot.angleTo(triangle.beacon1)));
        angles.add(toTheLeft(robot, robot.angleTo(triangle.beacon2)));
        angles.add(toTheLeft(robot, robot.angleTo(triangle.beacon3)));
        return angles;
    }

    private static double toTheLeft(Pose robot, double direction) {
        double angle = 360 - (robot.getHeading() - direction);
        while (angle >= 360) angle -= 360;
        while (angle < 0) angle += 360;
        return angle;
    }

    /** Begins with the beacon behind the largest gap, which is the same one in both lists. */
    private static void sort(ArrayList<Double> seen, ArrayList<Double> expected) {
        ArrayList<Double> gaps = new ArrayList<Double>();
        for (int i = 0; i < BEACONS; i++) gaps.add(gap(expected.get(i), expected.get((i + 1) % BEACONS)));
        int largest = getLargestIndex(gaps);
        double middle = expected.get(largest) + gaps.get(largest) / 2;
        if (middle >= 360) middle -= 360;
        int first = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < BEACONS; i++) {
            double behind = gap(middle, seen.get(i));
            if (behind < least) {
                least = behind;
                first = i;
            }
        }
        double[] sorted = new double[BEACONS];
        for (int i = 0; i < BEACONS; i++) sorted[(largest + 1 + i) % BEACONS] = seen.get((first + i) % BEACONS);
        for (int i = 0; i < BEACONS; i++) seen.set(i, sorted[i]);
    }

    private static double gap(double from, double to) {
        return to < from ? to + 360 - from : to - from;
    }

    /** Gives the place of the largest of three numbers above 0. */
    public static int getLargestIndex(ArrayList<Double> angles) {
        int place = 0;
        double largest = 0;
        for (int i = 0; i < BEACONS; i++) {
            if (angles.get(i) > largest) {
                largest = angles.get(i);
                place = i;
            }
        }
        return place;
    }

    /** Does nothing, as in leJOS NXJ. */
    public void setPose(Pose aPose) {
    }

    /** Is told by the pilot; programs need not call it. */
    public void moveStarted(Move move, MoveProvider mp) {
    }

    /** Is told by the pilot; programs need not call it. */
    public void moveStopped(Move move, MoveProvider mp) {
        moves++;
    }
}
