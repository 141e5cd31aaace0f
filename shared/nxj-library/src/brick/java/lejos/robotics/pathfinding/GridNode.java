package lejos.robotics.pathfinding;

/** A node of a grid, in which a way goes only across and up or down; all grids of a program have the same size. */
public class GridNode extends Node {
    private static float size;

    /** Makes one of a grid with so large squares. */
    public GridNode(float x, float y, float grid_space) {
        super(x, y);
        size = grid_space;
    }

    /** Gives the size of the squares. */
    protected float calculateG(Node neighbor) {
        return size;
    }

    /** Gives how far it is to the goal across, and up or down. */
    protected float calculateH(Node neighbor) {
        return Math.abs(x - neighbor.x) + Math.abs(y - neighbor.y);
    }
}
