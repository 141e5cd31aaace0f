public class Determinants {
    static double determinant(double[][] matrix) {
        int size = matrix.length;
        double[][] rows = new double[size][];
        for (int row = 0; row < size; row++) rows[row] = matrix[row].clone();
        double result = 1;
        for (int column = 0; column < size; column++) {
            int best = column;
            for (int row = column + 1; row < size; row++) {
                if (Math.abs(rows[row][column]) > Math.abs(rows[best][column])) best = row;
            }
            if (rows[best][column] == 0) return 0;
            if (best != column) {
                double[] other = rows[best];
                rows[best] = rows[column];
                rows[column] = other;
                result = -result;
            }
            result *= rows[column][column];
            for (int row = column + 1; row < size; row++) {
                double factor = rows[row][column] / rows[column][column];
                for (int i = column; i < size; i++) rows[row][i] -= factor * rows[column][i];
            }
        }
        return result;
    }

    static float[][] product(float[][] left, float[][] right) {
        float[][] result = new float[left.length][right[0].length];
        for (int row = 0; row < left.length; row++) {
            for (int column = 0; column < right[0].length; column++) {
                for (int i = 0; i < right.length; i++) result[row][column] += left[row][i] * right[i][column];
            }
        }
        return result;
    }

    public static void main(String[] arguments) {
        System.out.println(determinant(new double[][] {{2, 1}, {4, 8}}));
        System.out.println(determinant(new double[][] {{0, 1, 2}, {4, 0, 1}, {2, 2, 0.5}}));
        System.out.println(determinant(new double[][] {{1, 2}, {2, 4}}));
        float[][] turn = {{0, -1}, {1, 0}};
        float[][] place = {{3.5f}, {-2}};
        for (int i = 0; i < 3; i++) place = product(turn, place);
        System.out.println(place[0][0] + " " + place[1][0]);
        // expect 12.0
        // expect 16.0
        // expect 0.0
        // expect -2.0 -3.5
    }
}
