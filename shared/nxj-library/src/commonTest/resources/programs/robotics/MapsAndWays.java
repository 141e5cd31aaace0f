import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import lejos.geom.Line;
import lejos.geom.Point;
import lejos.geom.Rectangle;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.mapping.ShapefileLoader;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;
import lejos.robotics.pathfinding.AstarSearchAlgorithm;
import lejos.robotics.pathfinding.FourWayGridMesh;
import lejos.robotics.pathfinding.Node;
import lejos.robotics.pathfinding.NodePathFinder;
import lejos.robotics.pathfinding.Path;
import lejos.robotics.pathfinding.PathFinder;
import lejos.robotics.pathfinding.ShortestPathFinder;

/** A room with a wall in it: what a robot sees of it, and ways around the wall. */
public class MapsAndWays {
    static LineMap room() {
        return new LineMap(new Line[] {
            new Line(0, 0, 100, 0), new Line(100, 0, 100, 100), new Line(100, 100, 0, 100), new Line(0, 100, 0, 0),
            new Line(50, 0, 50, 60),
        }, new Rectangle(0, 0, 100, 100));
    }

    static String text(Path path) {
        StringBuilder text = new StringBuilder();
        for (Waypoint point : path) text.append(Math.round(point.x)).append(',').append(Math.round(point.y)).append(' ');
        return text.toString();
    }

    static void sight(LineMap map) throws IOException {
        System.out.println(map.range(new Pose(20, 30, 0)) + " " + map.range(new Pose(20, 80, 0))); // expect 30.0 80.0
        System.out.println(map.range(new Pose(20, 30, 90)) + " " + map.range(new Pose(200, 30, 0))); // expect 70.0 -1.0
        System.out.println(map.inside(new Point(20, 30)) + " " + map.inside(new Point(70, 80)) + " " + map.inside(new Point(-1, 30))); // expect true true false
        // Left of it are the wall and the side of the room, so it counts as outside.
        System.out.println(map.inside(new Point(70, 30))); // expect false
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        map.dumpObject(new DataOutputStream(bytes));
        LineMap read = new LineMap();
        read.loadObject(new DataInputStream(new ByteArrayInputStream(bytes.toByteArray())));
        System.out.println(read.getLines().length + " " + read.getLines()[4].y2 + " " + read.getBoundingRect().width); // expect 5 60.0 100.0
        System.out.println(read.flip().range(new Pose(20, 30, 0)) + " " + read.flip().range(new Pose(20, 70, 0))); // expect 80.0 30.0
    }

    static void grid(LineMap map) throws DestinationUnreachableException {
        FourWayGridMesh mesh = new FourWayGridMesh(map, 20, 10);
        System.out.println(mesh.getMesh().size()); // expect 16
        NodePathFinder finder = new NodePathFinder(new AstarSearchAlgorithm(), mesh);
        System.out.println(text(finder.findRoute(new Pose(12, 12, 0), new Waypoint(88, 12)))); // expect 12,12 30,30 30,50 30,70 50,70 70,70 70,50 70,30 88,12 
        System.out.println(mesh.getMesh().size()); // expect 16
        Node alone = new Node(300, 300);
        System.out.println(mesh.addNode(alone, 4) + " " + alone.neighbors() + " " + mesh.removeNode(alone)); // expect 0 0 true
        try {
            finder.findRoute(new Pose(12, 12, 0), new Waypoint(300, 300));
        } catch (DestinationUnreachableException e) {
            System.out.println("unreachable"); // expect unreachable
        }
        System.out.println(new AstarSearchAlgorithm()); // expect A*
    }

    static void corners(LineMap map) throws DestinationUnreachableException {
        ShortestPathFinder finder = new ShortestPathFinder(map);
        // The way along the wall at the bottom is longer: a brick finds it free, since it calculates with float numbers.
        System.out.println(text(finder.findRoute(new Pose(20, 45, 0), new Waypoint(80, 45)))); // expect DONE
        // expect 20,45 50,60 80,45 
        finder.lengthenLines(5);
        System.out.println(text(finder.findRoute(new Pose(20, 20, 0), new Waypoint(80, 90)))); // expect DONE
        // expect 20,20 50,65 80,90 
        System.out.println(finder.getMap().size() + " " + (finder.getNodeCount() > 2) + " " + map.getLines()[4].y2); // expect 5 true 65.0
        final StringBuilder told = new StringBuilder();
        finder.addListener(new WaypointListener() {
            public void addWaypoint(Waypoint point) {
                told.append(Math.round(point.x)).append(' ');
            }

            public void pathGenerated() {
                told.append("end");
            }
        });
        ((PathFinder) finder).startPathFinding(new Pose(20, 20, 0), new Waypoint(30, 30)); // expect DONE
        System.out.println(told); // expect 20 30 end
    }

    static void little(DataOutputStream out, double value) throws IOException {
        out.writeLong(Long.reverseBytes(Double.doubleToLongBits(value)));
    }

    static void little(DataOutputStream out, int value) throws IOException {
        out.writeInt(Integer.reverseBytes(value));
    }

    static void shapes() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(bytes);
        out.writeInt(9994);
        for (int i = 0; i < 6; i++) out.writeInt(0);
        little(out, 1000);
        little(out, 3);
        double[] around = {10, 20, 110, 70, 0, 0, 0, 0};
        for (double edge : around) little(out, edge);
        out.writeInt(1);
        out.writeInt(50);
        little(out, 3);
        for (int i = 0; i < 4; i++) little(out, 0.0);
        little(out, 1);
        little(out, 3);
        little(out, 0);
        double[] points = {10, 20, 60, 20, 60, 70};
        for (double place : points) little(out, place);
        LineMap map = new ShapefileLoader(new ByteArrayInputStream(bytes.toByteArray())).readLineMap();
        Line last = map.getLines()[1];
        System.out.println(map.getLines().length + " " + last.x1 + " " + last.y2 + " " + map.getBoundingRect().height); // expect 2 60.0 70.0 50.0
        try {
            new ShapefileLoader(new ByteArrayInputStream(new byte[100])).readLineMap();
        } catch (IOException e) {
            System.out.println(e.getMessage()); // expect File is not a Shapefile
        }
    }

    public static void main(String[] arguments) throws Exception {
        LineMap map = room();
        sight(map);
        grid(map);
        corners(map);
        shapes();
    }
}
