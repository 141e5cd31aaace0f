package lejos.robotics.pathfinding;

import java.awt.geom.Point2D;
import java.util.Collection;

/** A node that makes neighbours by chance when it is asked for them; near the goal, the goal is one of them. */
public class RandomSelfGeneratingNode extends Node {
    private static Node goal;

    private final float maxDist;
    private final int connections;
    private boolean isAsked;

    /** Makes one whose neighbours are so far away at most, across and up or down, and how many there are. */
    public RandomSelfGeneratingNode(float x, float y, float maxDist, int connections) {
        super(x, y);
        this.maxDist = maxDist;
        this.connections = connections;
    }

    /** Makes one, and sets the goal of all of them. */
    public RandomSelfGeneratingNode(float x, float y, float maxDist, int connections, Node goal) {
        this(x, y, maxDist, connections);
        RandomSelfGeneratingNode.goal = goal;
    }

    /** Gives the neighbours, and makes them the first time. */
    public Collection<Node> getNeighbors() {
        if (!isAsked) {
            if ((float) Point2D.distance(goal.x, goal.y, x, y) <= maxDist) connect(goal);
            int more = connections - neighbors();
            for (int i = 0; i < more; i++) {
                float across = (float) (Math.random() * maxDist);
                float up = (float) (Math.random() * maxDist);
                if (Math.random() < 0.5) across = -across;
                if (Math.random() < 0.5) up = -up;
                connect(new RandomSelfGeneratingNode(x + across, y + up, maxDist, connections));
            }
            isAsked = true;
        }
        return super.getNeighbors();
    }

    private void connect(Node other) {
        addNeighbor(other);
        other.addNeighbor(this);
    }
}
