package lejos.robotics.pathfinding;

/** Looks for a way through nodes, from neighbour to neighbour. */
public interface SearchAlgorithm {
    /** Gives the points of the way, both ends with it, or null if there is none. */
    Path findPath(Node startNode, Node goalNode);
}
