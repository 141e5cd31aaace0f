package lejos.robotics.pathfinding;

import java.util.Collection;

/** Nodes all over a map, connected where a robot can drive. */
public interface NavigationMesh {
    /** Adds a node, connects it with at most so many others, and gives with how many. */
    int addNode(Node node, int neighbors);

    /** Takes a node away; false if it was not there. */
    boolean removeNode(Node node);

    /** Connects two nodes; false if something in the map is in between. */
    boolean connect(Node node1, Node node2);

    /** Takes the connection of two nodes away. */
    boolean disconnect(Node node1, Node node2);

    /** Gives all nodes. */
    Collection<Node> getMesh();

    /** Makes all nodes anew. */
    void regenerate();
}
