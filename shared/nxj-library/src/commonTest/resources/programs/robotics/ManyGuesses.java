import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import lejos.geom.Line;
import lejos.geom.Rectangle;
import lejos.robotics.RangeFinder;
import lejos.robotics.RangeReadings;
import lejos.robotics.RangeScanner;
import lejos.robotics.localization.MCLParticle;
import lejos.robotics.localization.MCLParticleSet;
import lejos.robotics.localization.MCLPoseProvider;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;

/** A robot finds out where it is from many guesses, its moves, and what it measures. */
public class ManyGuesses {
    static final LineMap room = new LineMap(new Line[] {
        new Line(0, 0, 150, 0), new Line(150, 0, 150, 100), new Line(150, 100, 60, 100), new Line(60, 100, 60, 70),
        new Line(60, 70, 0, 70), new Line(0, 70, 0, 0),
    }, new Rectangle(0, 0, 150, 100));

    static final float[] angles = {-90, 0, 90};

    /** Where the robot really is. */
    static final Pose robot = new Pose(40, 30, 0);

    static RangeReadings measured() {
        RangeReadings readings = new RangeReadings(angles.length);
        for (int i = 0; i < angles.length; i++) {
            readings.setRange(i, angles[i], room.range(new Pose(robot.getX(), robot.getY(), robot.getHeading() + angles[i])));
        }
        return readings;
    }

    static boolean isNear(Pose pose) {
        return Math.abs(pose.getX() - robot.getX()) < 8 && Math.abs(pose.getY() - robot.getY()) < 8;
    }

    public static void main(String[] arguments) throws Exception {
        RangeReadings readings = measured();
        MCLParticle right = new MCLParticle(new Pose(40, 30, 0));
        right.calculateWeight(readings, room, 400);
        MCLParticle wrong = new MCLParticle(new Pose(80, 50, 0));
        wrong.calculateWeight(readings, room, 400);
        MCLParticle outside = new MCLParticle(new Pose(20, 90, 0));
        outside.calculateWeight(readings, room, 400);
        System.out.println(right.getWeight() + " " + (wrong.getWeight() < 0.01f) + " " + outside.getWeight()); // expect 1.0 true 0.0
        System.out.println(right.getReadings(readings, room).getRange(2) + " " + right.getReading(0, readings, room)); // expect 40.0 30.0
        right.applyMove(new Move(Move.MoveType.TRAVEL, 10, 0, false), 0, 0);
        right.applyMove(new Move(Move.MoveType.ROTATE, 0, 90, false), 0, 0);
        System.out.println(right.getPose().getX() + " " + right.getPose().getHeading()); // expect 50.0 90.0

        MCLParticleSet set = new MCLParticleSet(room, 60, 5);
        boolean areInside = true;
        for (int i = 0; i < set.numParticles(); i++) areInside &= room.inside(set.getParticle(i).getPose().getLocation());
        System.out.println(areInside + " " + set.getBorder()); // expect true 5.0
        set.getParticle(7).getPose().setLocation(new lejos.geom.Point(1, 1));
        System.out.println(set.findClosest(0, 0)); // expect 7
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        set.dumpObject(new DataOutputStream(bytes));
        System.out.println(bytes.size()); // expect 968
        MCLParticleSet read = new MCLParticleSet(room, 1, 5);
        read.loadObject(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())));
        System.out.println(read.numParticles() + " " + read.getParticle(7).getPose().getX()); // expect 60 1.0

        RangeScanner scanner = new RangeScanner() {
            public RangeReadings getRangeValues() {
                return measured();
            }

            public void setAngles(float[] wanted) {
            }

            public RangeFinder getRangeFinder() {
                return null;
            }
        };
        MCLPoseProvider provider = new MCLPoseProvider(null, scanner, room, 150, 0);
        provider.setInitialPose(new Pose(40, 30, 0), 5, 3);
        System.out.println(provider.update() + " " + provider.isUpdated() + " " + provider.incompleteRanges()); // expect true true false
        System.out.println(isNear(provider.getPose()) + " " + (provider.getXRange() < 40)); // expect true true
        robot.setLocation(new lejos.geom.Point(70, 30));
        Move move = new Move(Move.MoveType.TRAVEL, 30, 0, false);
        provider.moveStarted(move, null);
        provider.moveStopped(move, null);
        do {
            Thread.sleep(5);
        } while (provider.isBusy());
        System.out.println(isNear(provider.getPose()) + " " + provider.isUpdated()); // expect true true
        System.out.println((provider.getSigmaX() < 15) + " " + (provider.getErrorRect().width == (int) provider.getXRange())); // expect true true
        provider.setPose(new Pose(70, 30, 0));
        System.out.println(isNear(provider.getPose()) + " " + (provider.getScanner() == scanner)); // expect true true
        System.exit(0);
    }
}
