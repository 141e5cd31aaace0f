public class Queens {
    private final int[] columns;
    private int solutions;
    private String first;

    Queens(int size) {
        columns = new int[size];
        place(0);
    }

    private boolean isFree(int row, int column) {
        for (int other = 0; other < row; other++) {
            int distance = columns[other] - column;
            if (distance == 0 || Math.abs(distance) == row - other) return false;
        }
        return true;
    }

    private void place(int row) {
        if (row == columns.length) {
            if (solutions++ == 0) {
                StringBuilder text = new StringBuilder();
                for (int column : columns) text.append(column);
                first = text.toString();
            }
            return;
        }
        for (int column = 0; column < columns.length; column++) {
            if (!isFree(row, column)) continue;
            columns[row] = column;
            place(row + 1);
        }
    }

    public static void main(String[] arguments) {
        for (int size = 1; size <= 6; size++) {
            Queens queens = new Queens(size);
            System.out.println(size + ": " + queens.solutions + " " + queens.first);
        }
        // expect 1: 1 0
        // expect 2: 0 null
        // expect 3: 0 null
        // expect 4: 2 1302
        // expect 5: 10 02413
        // expect 6: 4 135024
    }
}
