package lejos.robotics.pathfinding;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.Collection;

/** A place on the ways of a robot, and the places next to it. */
public class Node {
    /** Where it is, from left to right. */
    public float x;

    /** Where it is, from below upward. */
    public float y;

    private final ArrayList<Node> neighbors = new ArrayList<Node>();
    private float fromStart;
    private float toGoal;
    private Node predecessor;

    /** Makes one without neighbours. */
    public Node(float x, float y) {
        this.x = x;
        this.y = y;
    }

    /** Gives the neighbours. */
    public Collection<Node> getNeighbors() {
        return neighbors;
    }

    /** Gives how many neighbours it has. */
    public int neighbors() {
        return neighbors.size();
    }

    /** Adds a neighbour, which does not have this one as a neighbour yet; false if it was one, or is this node. */
    public boolean addNeighbor(Node neighbor) {
        return !neighbors.contains(neighbor) && neighbor != this && neighbors.add(neighbor);
    }

    /** Takes a neighbour away, which still has this one as a neighbour; false if it was none. */
    public boolean removeNeighbor(Node neighbor) {
        return neighbors.remove(neighbor);
    }

    /** Sets how far it is from here to the goal, as well as one can tell. */
    protected void setH_Score(float h) {
        toGoal = h;
    }

    /** Gives how far it is from here to a neighbour. */
    protected float calculateG(Node neighbor) {
        return (float) Point2D.distance(x, y, neighbor.x, neighbor.y);
    }

    /** Gives how far it is from here to the goal, as well as one can tell. */
    protected float calculateH(Node goal) {
        return calculateG(goal);
    }

    /** Sets how far it is from the start to here. */
    protected void setG_Score(float g) {
        fromStart = g;
    }

    /** Gives how far it is from the start to here. */
    protected float getG_Score() {
        return fromStart;
    }

    /** Gives how far it is from the start over here to the goal. */
    protected float getF_Score() {
        return fromStart + toGoal;
    }

    /** Gives the node before this one on the way. */
    protected Node getPredecessor() {
        return predecessor;
    }

    /** Sets the node before this one on the way. */
    protected void setPredecessor(Node orig) {
        predecessor = orig;
    }
}
