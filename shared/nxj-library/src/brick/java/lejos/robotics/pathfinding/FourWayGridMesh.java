package lejos.robotics.pathfinding;

import java.util.ArrayList;
import java.util.Collection;
import lejos.geom.Line;
import lejos.geom.Rectangle;
import lejos.robotics.mapping.LineMap;

/** A grid of nodes over a map; each is connected with the next ones to all four sides, as far as walls allow. */
public class FourWayGridMesh implements NavigationMesh {
    private ArrayList<Node> mesh;
    private LineMap map;
    private float clearance;
    private float gridSpace;

    /** Makes one of a map, the size of a square, and how far ways are from walls. */
    public FourWayGridMesh(LineMap map, float gridSpace, float clearance) {
        setMap(map);
        setClearance(clearance);
        setGridSpacing(gridSpace);
    }

    /** Gives all nodes. */
    public Collection<Node> getMesh() {
        if (mesh == null) regenerate();
        return mesh;
    }

    /** Sets the size of a square, for regenerate. */
    public void setGridSpacing(float gridSpace) {
        this.gridSpace = gridSpace;
    }

    /** Sets how far ways are from walls, for regenerate. */
    public void setClearance(float clearance) {
        this.clearance = clearance;
    }

    /** Sets the map, for regenerate. */
    public void setMap(LineMap map) {
        this.map = map;
    }

    /** Makes all nodes anew. */
    public void regenerate() {
        mesh = new ArrayList<Node>();
        Rectangle around = map.getBoundingRect();
        float right = around.width + around.x - clearance;
        float top = around.height + around.y - clearance;
        int rows = 0;
        for (float y = around.y + clearance; y < top; y += gridSpace) {
            rows++;
            for (float x = around.x + clearance; x < right; x += gridSpace) mesh.add(new GridNode(x, y, gridSpace));
        }
        int columns = mesh.size() / rows;
        for (int i = 0; i + 1 < mesh.size(); i++) {
            Node node = mesh.get(i);
            if (i + columns < mesh.size()) connect(node, mesh.get(i + columns));
            if ((i + 1) % columns != 0) connect(node, mesh.get(i + 1));
        }
    }

    /** Connects two nodes; false if one is outside of the map, or if the way comes too near to a wall. */
    public boolean connect(Node node1, Node node2) {
        if (map != null) {
            Rectangle around = map.getBoundingRect();
            if (!around.contains(node1.x, node1.y) || !around.contains(node2.x, node2.y)) return false;
            Line way = new Line(node1.x, node1.y, node2.x, node2.y);
            for (Line line : map.getLines()) {
                if (line.segDist(way) < clearance) return false;
            }
        }
        node1.addNeighbor(node2);
        node2.addNeighbor(node1);
        return true;
    }

    /** Takes the connection of two nodes away; true, even if there was none. */
    public boolean disconnect(Node node1, Node node2) {
        node1.removeNeighbor(node2);
        node2.removeNeighbor(node1);
        return true;
    }

    /** Adds a node, connects it with at most so many of the square around it, and gives with how many. */
    public int addNode(Node node, int neighbors) {
        int connected = 0;
        for (Node other : getMesh()) {
            if (Math.abs(other.x - node.x) > gridSpace || Math.abs(other.y - node.y) > gridSpace) continue;
            if (connect(node, other)) connected++;
            if (connected >= neighbors) break;
        }
        mesh.add(node);
        return connected;
    }

    /** Takes a node and its connections away; false if it was not there. */
    public boolean removeNode(Node node) {
        for (Node neighbor : new ArrayList<Node>(node.getNeighbors())) disconnect(node, neighbor);
        return mesh.remove(node);
    }
}
