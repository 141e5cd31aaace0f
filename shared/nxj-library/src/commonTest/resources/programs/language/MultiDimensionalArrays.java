public class MultiDimensionalArrays {
    public static void main(String[] arguments) {
        int[][] table = new int[3][4];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 4; column++) table[row][column] = row * 10 + column;
        }
        System.out.println(table[2][3]); // expect 23
        System.out.println(table.length * table[0].length); // expect 12
        int[][] triangle = {{1}, {2, 3}, {4, 5, 6}};
        int sum = 0;
        for (int row = 0; row < triangle.length; row++) {
            for (int column = 0; column < triangle[row].length; column++) sum += triangle[row][column];
        }
        System.out.println(sum); // expect 21
        char[][] open = new char[2][];
        System.out.println(open[1] == null ? 1 : 0); // expect 1
        open[1] = "four".toCharArray();
        System.out.println(open[1].length); // expect 4
        byte[][][] deep = new byte[2][][];
        for (int index = 0; index < 2; index++) deep[index] = new byte[2][2];
        deep[1][0][1] = 9;
        System.out.println(deep[1][0][1] + deep[0][1][0]); // expect 9
    }
}
