package lejos.util;

/** Takes a matrix apart into a lower and an upper triangle, so that equations can be solved. */
public class LUDecomposition {
    private final double[][] triangles;
    private final int rows;
    private final int columns;
    private final int[] order;
    private int sign = 1;

    /** Takes a matrix apart that has at least as many rows as columns. */
    public LUDecomposition(Matrix A) {
        triangles = A.getArrayCopy();
        rows = A.getRowDimension();
        columns = A.getColumnDimension();
        order = new int[rows];
        for (int i = 0; i < rows; i++) order[i] = i;
        double[] column = new double[rows];
        for (int j = 0; j < columns; j++) {
            for (int i = 0; i < rows; i++) column[i] = triangles[i][j];
            for (int i = 0; i < rows; i++) {
                double[] row = triangles[i];
                double sum = 0;
                for (int k = 0; k < Math.min(i, j); k++) sum += row[k] * column[k];
                column[i] -= sum;
                row[j] = column[i];
            }
            exchange(j, largest(column, j));
            if (j < rows && triangles[j][j] != 0) {
                for (int i = j + 1; i < rows; i++) triangles[i][j] /= triangles[j][j];
            }
        }
    }

    private int largest(double[] column, int from) {
        int place = from;
        for (int i = from + 1; i < rows; i++) {
            if (Math.abs(column[i]) > Math.abs(column[place])) place = i;
        }
        return place;
    }

    private void exchange(int a, int b) {
        if (a == b) return;
        double[] row = triangles[a];
        triangles[a] = triangles[b];
        triangles[b] = row;
        int place = order[a];
        order[a] = order[b];
        order[b] = place;
        sign = -sign;
    }

    /** Tells whether equations with this matrix have one solution. */
    public boolean isNonsingular() {
        for (int j = 0; j < columns; j++) {
            if (triangles[j][j] == 0) return false;
        }
        return true;
    }

    /** Gives the lower triangle, with ones in its diagonal. */
    public Matrix getL() {
        Matrix lower = new Matrix(rows, columns);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns && j <= i; j++) lower.set(i, j, i == j ? 1 : triangles[i][j]);
        }
        return lower;
    }

    /** Gives the upper triangle. */
    public Matrix getU() {
        Matrix upper = new Matrix(columns, columns);
        for (int i = 0; i < columns; i++) {
            for (int j = i; j < columns; j++) upper.set(i, j, triangles[i][j]);
        }
        return upper;
    }

    /** Gives the order of the rows of the matrix in the triangles. */
    public int[] getPivot() {
        return order.clone();
    }

    /** Gives the order of the rows of the matrix in the triangles as decimal numbers. */
    public double[] getDoublePivot() {
        double[] places = new double[rows];
        for (int i = 0; i < rows; i++) places[i] = order[i];
        return places;
    }

    /** Gives the determinant of the matrix, which must be a square. */
    public double det() {
        if (rows != columns) throw new IllegalArgumentException("Matrix must be square.");
        double product = sign;
        for (int j = 0; j < columns; j++) product *= triangles[j][j];
        return product;
    }

    /** Gives the matrix that is the other one if the matrix is multiplied by it. */
    public Matrix solve(Matrix B) {
        if (B.getRowDimension() != rows) throw new IllegalArgumentException("Matrix row dimensions must agree.");
        if (!isNonsingular()) throw new RuntimeException("Matrix is singular.");
        int width = B.getColumnDimension();
        Matrix solution = B.getMatrix(order, 0, width - 1);
        double[][] x = solution.getArray();
        for (int k = 0; k < columns; k++) {
            for (int i = k + 1; i < columns; i++) {
                for (int j = 0; j < width; j++) x[i][j] -= x[k][j] * triangles[i][k];
            }
        }
        for (int k = columns - 1; k >= 0; k--) {
            for (int j = 0; j < width; j++) x[k][j] /= triangles[k][k];
            for (int i = 0; i < k; i++) {
                for (int j = 0; j < width; j++) x[i][j] -= x[k][j] * triangles[i][k];
            }
        }
        return solution;
    }
}
