import java.util.ArrayList;
import java.util.LinkedList;
import java.util.List;

public class PathsInAMaze {
    static final String[] MAZE = {"#########", "#S..#...#", "###.#.#.#", "#...#.#.#", "#.###.#.#", "#.....#E#", "#########"};

    static class Place {
        final int row;
        final int column;
        final Place before;

        Place(int row, int column, Place before) {
            this.row = row;
            this.column = column;
            this.before = before;
        }
    }

    enum Direction {
        NORTH(-1, 0), EAST(0, 1), SOUTH(1, 0), WEST(0, -1);

        final int rows;
        final int columns;

        Direction(int rows, int columns) {
            this.rows = rows;
            this.columns = columns;
        }
    }

    static Place search(char goal) {
        boolean[][] seen = new boolean[MAZE.length][MAZE[0].length()];
        LinkedList<Place> open = new LinkedList<Place>();
        open.add(new Place(1, 1, null));
        seen[1][1] = true;
        while (!open.isEmpty()) {
            Place place = open.remove(0);
            if (MAZE[place.row].charAt(place.column) == goal) return place;
            for (Direction direction : Direction.values()) {
                int row = place.row + direction.rows;
                int column = place.column + direction.columns;
                if (seen[row][column] || MAZE[row].charAt(column) == '#') continue;
                seen[row][column] = true;
                open.add(new Place(row, column, place));
            }
        }
        return null;
    }

    public static void main(String[] arguments) {
        List<String> turns = new ArrayList<String>();
        Place place = search('E');
        int steps = 0;
        while (place.before != null) {
            for (Direction direction : Direction.values()) {
                boolean isThis = place.row - place.before.row == direction.rows && place.column - place.before.column == direction.columns;
                if (isThis && (turns.isEmpty() || !turns.get(0).equals(direction.name()))) turns.add(0, direction.name());
            }
            place = place.before;
            steps++;
        }
        System.out.println(steps);
        System.out.println(turns);
        System.out.println(search('X'));
        // expect 22
        // expect [EAST, SOUTH, WEST, SOUTH, EAST, NORTH, EAST, SOUTH]
        // expect null
    }
}
