package lejos.robotics.pathfinding;

import java.util.ArrayList;
import lejos.robotics.navigation.Waypoint;

/** The search A*: it goes on from the node over which the way seems to be shortest. */
public class AstarSearchAlgorithm implements SearchAlgorithm {
    /** Makes one. */
    public AstarSearchAlgorithm() {
    }

    /** Gives the points of the way, both ends with it, or null if there is none. */
    public Path findPath(Node start, Node goal) {
        ArrayList<Node> closed = new ArrayList<Node>();
        ArrayList<Node> open = new ArrayList<Node>();
        open.add(start);
        start.setG_Score(0);
        start.setH_Score(start.calculateH(goal));
        while (!open.isEmpty()) {
            Node best = best(open);
            if (best == goal) return path(start, goal);
            open.remove(best);
            closed.add(best);
            for (Node next : best.getNeighbors()) {
                if (closed.contains(next)) continue;
                float way = best.getG_Score() + best.calculateG(next);
                boolean isNew = !open.contains(next);
                if (isNew) open.add(next);
                if (isNew || way < next.getG_Score()) next.setPredecessor(best);
                next.setG_Score(way);
                next.setH_Score(next.calculateH(goal));
            }
        }
        return null;
    }

    private static Node best(ArrayList<Node> nodes) {
        Node best = nodes.get(0);
        for (Node node : nodes) {
            if (node.getF_Score() < best.getF_Score()) best = node;
        }
        return best;
    }

    private static Path path(Node start, Node goal) {
        Path path = new Path();
        for (Node node = goal; node != start; node = node.getPredecessor()) path.add(0, new Waypoint(node.x, node.y));
        path.add(0, new Waypoint(start.x, start.y));
        return path;
    }

    /** Gives its name. */
    public String toString() {
        return "A*";
    }
}
