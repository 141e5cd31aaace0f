import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

public class CollectionsTogether {
    static class Point {
        final int x;
        final int y;

        Point(int x, int y) {
            this.x = x;
            this.y = y;
        }

        @Override
        public boolean equals(Object other) {
            if (!(other instanceof Point)) return false;
            Point point = (Point) other;
            return point.x == x && point.y == y;
        }

        @Override
        public int hashCode() {
            return x * 1000 + y;
        }

        @Override
        public String toString() {
            return "(" + x + "," + y + ")";
        }
    }

    private static final int[][] STEPS = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    private static final String[] MAZE = {"....#", ".##.#", ".#...", ".###.", "....."};

    /** The shortest way through a maze, by breadth-first search. */
    static int steps(Point from, Point to) {
        Map<Point, Integer> distances = new HashMap<Point, Integer>();
        List<Point> queue = new ArrayList<Point>();
        distances.put(from, 0);
        queue.add(from);
        while (!queue.isEmpty()) {
            Point here = queue.remove(0);
            if (here.equals(to)) return distances.get(here);
            for (int[] step : STEPS) {
                Point next = new Point(here.x + step[0], here.y + step[1]);
                boolean isInside = next.x >= 0 && next.y >= 0 && next.x < 5 && next.y < 5;
                if (!isInside || MAZE[next.y].charAt(next.x) == '#' || distances.containsKey(next)) continue;
                distances.put(next, distances.get(here) + 1);
                queue.add(next);
            }
        }
        return -1;
    }

    public static void main(String[] arguments) {
        System.out.println(steps(new Point(0, 0), new Point(4, 4))); // expect 8
        System.out.println(steps(new Point(0, 0), new Point(2, 2))); // expect 6
        System.out.println(steps(new Point(0, 0), new Point(4, 0))); // expect -1
        Map<String, List<Point>> groups = new HashMap<String, List<Point>>();
        for (int i = 0; i < 9; i++) {
            String key = i % 3 == 0 ? "fizz" : "other";
            List<Point> group = groups.get(key);
            if (group == null) {
                group = new ArrayList<Point>();
                groups.put(key, group);
            }
            group.add(new Point(i, i * i));
        }
        System.out.println(groups.get("fizz")); // expect [(0,0), (3,9), (6,36)]
        System.out.println(groups.get("other").size()); // expect 6
        System.out.println(groups.get("fizz").contains(new Point(3, 9))); // expect true
    }
}
