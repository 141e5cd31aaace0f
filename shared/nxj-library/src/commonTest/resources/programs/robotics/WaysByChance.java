import lejos.geom.Line;
import lejos.geom.Rectangle;
import lejos.robotics.RangeReadings;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.pathfinding.AstarSearchAlgorithm;
import lejos.robotics.pathfinding.Node;
import lejos.robotics.pathfinding.Path;
import lejos.robotics.pathfinding.RandomPathFinder;
import lejos.robotics.pathfinding.RandomSelfGeneratingNode;

/** Ways that are found by chance begin and end where they should, and keep clear of walls. */
public class WaysByChance {
    public static void main(String[] arguments) throws Exception {
        LineMap room = new LineMap(new Line[] {
            new Line(0, 0, 200, 0), new Line(200, 0, 200, 100), new Line(200, 100, 0, 100), new Line(0, 100, 0, 0),
        }, new Rectangle(0, 0, 200, 100));
        RandomPathFinder finder = new RandomPathFinder(room, new RangeReadings(2));
        finder.setMaxDistance(80);
        finder.setMaxRange(250);
        Path path = finder.findRoute(new Pose(20, 50, 0), new Waypoint(180, 50));
        Waypoint last = path.get(path.size() - 1);
        System.out.println((path.size() > 1) + " " + last.x + " " + last.y); // expect true 180.0 50.0
        boolean isShort = true;
        boolean isClear = true;
        Waypoint before = new Waypoint(20, 50);
        for (Waypoint point : path) {
            if (point.distance(before) > 80) isShort = false;
            if (point.x < 20 || point.y < 20 || point.x > 180 || point.y > 80) isClear = false;
            before = point;
        }
        System.out.println(isShort + " " + isClear); // expect true true
        Node goal = new Node(30, 30);
        Node start = new RandomSelfGeneratingNode(0, 0, 20, 4, goal);
        System.out.println(start.getNeighbors().size() + " " + start.neighbors()); // expect 4 4
        Path steps = new AstarSearchAlgorithm().findPath(start, goal);
        System.out.println(steps.get(0).x + " " + steps.get(steps.size() - 1).y); // expect 0.0 30.0
    }
}
