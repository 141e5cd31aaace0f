public class MatricesAndVectors {
    static double[][] product(double[][] a, double[][] b) {
        double[][] result = new double[a.length][b[0].length];
        for (int i = 0; i < a.length; i++) {
            for (int j = 0; j < b[0].length; j++) {
                for (int k = 0; k < b.length; k++) result[i][j] += a[i][k] * b[k][j];
            }
        }
        return result;
    }

    static double determinant(double[][] matrix) {
        int size = matrix.length;
        double[][] m = new double[size][];
        for (int i = 0; i < size; i++) m[i] = matrix[i].clone();
        double result = 1;
        for (int column = 0; column < size; column++) {
            int pivot = column;
            for (int row = column + 1; row < size; row++) {
                if (Math.abs(m[row][column]) > Math.abs(m[pivot][column])) pivot = row;
            }
            if (m[pivot][column] == 0) return 0;
            if (pivot != column) {
                double[] swap = m[pivot];
                m[pivot] = m[column];
                m[column] = swap;
                result = -result;
            }
            result *= m[column][column];
            for (int row = column + 1; row < size; row++) {
                double factor = m[row][column] / m[column][column];
                for (int k = column; k < size; k++) m[row][k] -= factor * m[column][k];
            }
        }
        return result;
    }

    public static void main(String[] arguments) {
        double[][] a = {{1, 2}, {3, 4}};
        double[][] b = {{0, 1}, {1, 0}};
        double[][] c = product(a, b);
        System.out.println(c[0][0] + " " + c[0][1] + " " + c[1][0] + " " + c[1][1]); // expect 2.0 1.0 4.0 3.0
        System.out.println(determinant(a) + " " + determinant(new double[][] {{2, 0, 1}, {1, 3, 2}, {1, 1, 4}})); // expect -2.0 18.0
        float[] direction = {3, 4};
        float length = (float) Math.sqrt(direction[0] * direction[0] + direction[1] * direction[1]);
        direction[0] /= length;
        direction[1] /= length;
        System.out.println(length + " " + direction[0] + " " + direction[1]); // expect 5.0 0.6 0.8
        double angle = Math.toRadians(30);
        double[][] turn = {{Math.cos(angle), -Math.sin(angle)}, {Math.sin(angle), Math.cos(angle)}};
        double[][] point = {{10}, {0}};
        for (int i = 0; i < 3; i++) point = product(turn, point);
        System.out.println(Math.round(point[0][0]) + " " + Math.round(point[1][0])); // expect 0 10
    }
}
