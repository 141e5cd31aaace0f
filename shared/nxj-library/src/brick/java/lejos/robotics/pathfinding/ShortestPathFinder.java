package lejos.robotics.pathfinding;

import java.util.ArrayList;
import lejos.geom.Line;
import lejos.geom.Point;
import lejos.robotics.mapping.LineMap;
import lejos.robotics.navigation.DestinationUnreachableException;
import lejos.robotics.navigation.Pose;
import lejos.robotics.navigation.Waypoint;
import lejos.robotics.navigation.WaypointListener;

/**
 * Finds the shortest way around walls: from end of a wall to end of a wall.
 *
 * <p>A robot is no point, so make the walls longer by lengthenLines. As in leJOS NXJ, it writes DONE on the display.
 */
public class ShortestPathFinder implements PathFinder {
    private final WaypointListeners listeners = new WaypointListeners();
    private ArrayList<Line> map = new ArrayList<Line>();

    /** Where the way is known, and what may be on the way, in the order of how far it is to the destination. */
    private ArrayList<Corner> reached = new ArrayList<Corner>();
    private ArrayList<Corner> candidates = new ArrayList<Corner>();

    private Corner destination;
    private int place;
    private int count;
    private boolean isTelling;

    /** Makes one of a map. */
    public ShortestPathFinder(LineMap map) {
        setMap(map);
    }

    /** Gives the points of the way, both ends with it. */
    public Path findRoute(Pose start, Waypoint finish) throws DestinationUnreachableException {
        return findPath(start.getLocation(), finish);
    }

    /** Adds the walls of a map, and gives the points of the way, both ends with it. */
    public Path findRoute(Pose start, Waypoint finish, LineMap theMap) throws DestinationUnreachableException {
        setMap(theMap);
        return findPath(start.getLocation(), finish);
    }

    private Path findPath(Point start, Point finish) throws DestinationUnreachableException {
        reached = new ArrayList<Corner>();
        candidates = new ArrayList<Corner>();
        reached.add(new Corner(start));
        destination = new Corner(finish);
        candidates.add(destination);
        place = 0;
        while (!reached.contains(destination)) {
            count++;
            Corner next = candidates.get(place);
            Corner from = best(next);
            tell("dest " + next + " from " + from);
            if (from.distanceTo(next) >= Corner.BLOCKED) giveUp(next);
            else if (isBlocked(from, next)) from.block(next);
            else reach(from, next);
        }
        System.out.println("DONE");
        return route();
    }

    /** Looks at the candidate behind this one; behind the last one, this one can never be reached. */
    private void giveUp(Corner corner) throws DestinationUnreachableException {
        place++;
        if (place < candidates.size()) return;
        if (corner == destination) {
            System.out.println("Destinatin unreachable");
            throw new DestinationUnreachableException();
        }
        tell("UNREACHABLE " + corner);
        corner.isUnreachable = true;
        candidates.remove(corner);
        place = 0;
    }

    private void reach(Corner from, Corner corner) {
        float distance = from.distanceTo(corner);
        boolean isSame = distance < 0.05f;
        corner.predecessor = isSame ? from.predecessor : from;
        corner.way = isSame ? from.way : from.way + distance;
        reached.add(corner);
        candidates.remove(corner);
        place = 0;
        tell("Moved from candidate to reached " + corner);
    }

    /** Whether a wall is in between; the ends of the last such wall become candidates. */
    private boolean isBlocked(Corner from, Corner to) {
        Line segment = new Line(from.point.x, from.point.y, to.point.x, to.point.y);
        Line wall = null;
        for (Line line : map) {
            if (line.intersectsAt(segment) != null && !from.isEndOf(line) && !to.isEndOf(line)) wall = line;
        }
        if (wall == null) return false;
        Corner first = new Corner(wall.getP1());
        if (isNew(first)) {
            first.way = from.way + from.distanceTo(first);
            add(first);
            place = candidates.indexOf(first);
        }
        Corner second = new Corner(wall.getP2());
        if (isNew(second)) {
            second.way = from.way + from.distanceTo(second);
            add(second);
        }
        return true;
    }

    private boolean isNew(Corner corner) {
        return !isIn(reached, corner) && !isIn(candidates, corner);
    }

    private static boolean isIn(ArrayList<Corner> corners, Corner corner) {
        for (Corner other : corners) {
            if (corner.point.equals(other.point)) return true;
        }
        return false;
    }

    private void add(Corner corner) {
        float distance = corner.distanceTo(destination);
        int index = 0;
        while (index < candidates.size() && distance >= candidates.get(index).distanceTo(destination)) index++;
        boolean isLast = index == candidates.size();
        candidates.add(index, corner);
        if (!isLast && index > 0 && place > index) place = index;
    }

    private Corner best(Corner next) {
        Corner best = reached.get(0);
        float least = best.way + best.distanceTo(next);
        for (Corner corner : reached) {
            float way = corner.way + corner.distanceTo(next);
            if (way < least) {
                least = way;
                best = corner;
            }
        }
        return best;
    }

    private Path route() {
        Path route = new Path();
        for (Corner corner = destination; corner != null; corner = corner.predecessor) {
            route.add(0, new Waypoint(corner.point));
        }
        return route;
    }

    /** Sets the walls. */
    public void setMap(ArrayList<Line> theMap) {
        map = theMap;
    }

    /** Adds the walls of a map to those that are there. */
    public void setMap(LineMap theMap) {
        for (Line line : theMap.getLines()) map.add(line);
    }

    /** Gives the walls. */
    public ArrayList<Line> getMap() {
        return map;
    }

    /** Says whether to write on the display what happens. */
    public void setDebug(boolean yes) {
        isTelling = yes;
    }

    private void tell(String text) {
        if (isTelling) System.out.println(text);
    }

    /** Makes all walls longer by so much at both ends, also in the map that they come from. */
    public void lengthenLines(float delta) {
        for (Line line : map) line.lengthen(delta);
    }

    /** Gives how many steps all searches took together. */
    public int getIterationCount() {
        return count;
    }

    /** Gives how many places the last search has reached. */
    public int getNodeCount() {
        return reached.size();
    }

    /** Adds a listener that is told of the points that startPathFinding finds. */
    public void addListener(WaypointListener wpl) {
        listeners.add(wpl);
    }

    /** Looks for the way, and tells the listeners if there is one. */
    public void startPathFinding(Pose start, Waypoint end) {
        try {
            listeners.tell(findPath(start.getLocation(), end));
        } catch (DestinationUnreachableException unreachable) {
            // Nobody is told, as in leJOS NXJ.
        }
    }

    /** An end of a wall, or an end of the way. */
    private static class Corner {
        static final float BLOCKED = 999999999;

        final Point point;
        private final ArrayList<Corner> blocked = new ArrayList<Corner>();
        Corner predecessor;
        float way;
        boolean isUnreachable;

        Corner(Point point) {
            this.point = point;
        }

        void block(Corner other) {
            blocked.add(other);
        }

        boolean isEndOf(Line line) {
            return point.equals(line.getP1()) || point.equals(line.getP2());
        }

        float distanceTo(Corner other) {
            if (other.isUnreachable || blocked.contains(other)) return BLOCKED;
            return (float) point.distance(other.point);
        }

        public String toString() {
            return " " + point.x + "," + point.y + " ";
        }
    }
}
