package lejos.robotics.pathfinding;

import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/** Finds a way by a search through the nodes of a mesh. */
public class NodePathFinder implements PathFinder {
    private static final int NEIGHBOURS = 4;

    private final WaypointListeners listeners = new WaypointListeners();
    private SearchAlgorithm algorithm;
    private NavigationMesh mesh;

    /** Makes one of a search, such as an AstarSearchAlgorithm, and a mesh, such as a FourWayGridMesh. */
    public NodePathFinder(SearchAlgorithm alg, NavigationMesh mesh) {
        setSearchAlgorithm(alg);
        setNavMesh(mesh);
    }

    /** Sets the mesh. */
    public void setNavMesh(NavigationMesh mesh) {
        this.mesh = mesh;
    }

    /** Sets the search. */
    public void setSearchAlgorithm(SearchAlgorithm alg) {
        algorithm = alg;
    }

    /** Adds a listener that is told of the points that startPathFinding finds. */
    public void addListener(WaypointListener wpl) {
        listeners.add(wpl);
    }

    /** Gives the points of the way, both ends with it. */
    public Path findRoute(Pose start, Waypoint goal) throws DestinationUnreachableException {
        Node from = new Node(start.getX(), start.getY());
        Node to = new Node((float) goal.getX(), (float) goal.getY());
        if (mesh != null) {
            mesh.addNode(from, NEIGHBOURS);
            mesh.addNode(to, NEIGHBOURS);
        }
        Path path = algorithm.findPath(from, to);
        if (path == null) throw new DestinationUnreachableException();
        if (mesh != null) {
            mesh.removeNode(from);
            mesh.removeNode(to);
        }
        return path;
    }

    /** Looks for the way, and tells the listeners; a NullPointerException if there is none. */
    public void startPathFinding(Pose start, Waypoint end) {
        Path path = null;
        try {
            path = findRoute(start, end);
        } catch (DestinationUnreachableException unreachable) {
            // The listeners get no way, as in leJOS NXJ.
        }
        listeners.tell(path);
    }
}
