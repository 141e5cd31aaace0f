public class GameOfLife {
    private static final int SIZE = 8;

    private boolean[][] cells = new boolean[SIZE][SIZE];

    private int neighbours(int row, int column) {
        int count = 0;
        for (int dr = -1; dr <= 1; dr++) {
            for (int dc = -1; dc <= 1; dc++) {
                if ((dr != 0 || dc != 0) && cells[(row + dr + SIZE) % SIZE][(column + dc + SIZE) % SIZE]) count++;
            }
        }
        return count;
    }

    void step() {
        boolean[][] next = new boolean[SIZE][];
        for (int row = 0; row < SIZE; row++) {
            next[row] = new boolean[SIZE];
            for (int column = 0; column < SIZE; column++) {
                int count = neighbours(row, column);
                next[row][column] = count == 3 || cells[row][column] && count == 2;
            }
        }
        cells = next;
    }

    String row(int row) {
        char[] letters = new char[SIZE];
        for (int column = 0; column < SIZE; column++) letters[column] = cells[row][column] ? '#' : '.';
        return new String(letters);
    }

    public static void main(String[] arguments) {
        GameOfLife game = new GameOfLife();
        int[][] glider = {{0, 1}, {1, 2}, {2, 0}, {2, 1}, {2, 2}};
        for (int[] cell : glider) game.cells[cell[0]][cell[1]] = true;
        for (int i = 0; i < 20; i++) game.step();
        for (int row = 0; row < SIZE; row++) System.out.println(game.row(row)); // expect ........
        // expect ........
        // expect ........
        // expect ........
        // expect ........
        // expect ......#.
        // expect .......#
        // expect .....###
    }
}
