import lejos.geom.Point;
import lejos.robotics.navigation.Move;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.pathfinding.Path;

public class Poses {
    static String shown(Pose pose) {
        return Math.round(pose.getX() * 10) + " " + Math.round(pose.getY() * 10) + " " + Math.round(pose.getHeading() * 10);
    }

    public static void main(String[] arguments) {
        Pose pose = new Pose();
        System.out.println(shown(pose)); // expect 0 0 0
        pose.moveUpdate(10);
        pose.rotateUpdate(90);
        pose.moveUpdate(5);
        System.out.println(shown(pose)); // expect 100 50 900
        pose.rotateUpdate(200);
        System.out.println(shown(pose)); // expect 100 50 -700
        pose.setHeading(-270);
        System.out.println(shown(pose)); // expect 100 50 -2700
        System.out.println(pose.distanceTo(new Point(13, 9)) + " " + Math.round(pose.angleTo(new Point(20, 5)))); // expect 5.0 0
        System.out.println(Math.round(pose.relativeBearing(new Point(20, 5)))); // expect -90
        Point ahead = pose.pointAt(10, 0);
        System.out.println(Math.round(ahead.x) + " " + Math.round(ahead.y)); // expect 20 5
        pose.arcUpdate((float) Math.PI * 10, 180);
        System.out.println(shown(pose)); // expect -100 50 -900
        pose.translate(1, -1);
        System.out.println(shown(pose)); // expect -90 40 -900
        Waypoint plain = new Waypoint(3, 4);
        Waypoint turned = new Waypoint(3, 4, 90);
        System.out.println(plain.isHeadingRequired() + " " + turned.isHeadingRequired() + " " + turned.getHeading()); // expect false true 90.0
        System.out.println(plain.getX() + " " + turned.getPose().getHeading()); // expect 3.0 90.0
        Path path = new Path();
        path.add(plain);
        path.add(turned);
        System.out.println(path.size() + " " + (path.get(0) == plain)); // expect 2 true
        Move arc = new Move(Move.MoveType.ARC, 10, 90, false);
        System.out.println(arc.getMoveType() + " " + Math.round(arc.getArcRadius() * 100) + " " + arc.getDistanceTraveled()); // expect ARC 637 10.0
        Move turn = new Move(Move.MoveType.ROTATE, 0, 45, true);
        System.out.println(turn.isMoving() + " " + turn.getAngleTurned()); // expect true 45.0
        System.out.println(Math.round(Move.convertAngleToDistance(180, 10)) + " " + Math.round(Move.convertDistanceToAngle(10, 10))); // expect 31 57
        for (Move.MoveType type : Move.MoveType.values()) System.out.println(type); // expect TRAVEL
        // expect ROTATE
        // expect ARC
        // expect STOP
    }
}
