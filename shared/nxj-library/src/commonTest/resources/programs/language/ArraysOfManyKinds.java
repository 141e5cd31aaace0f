public class ArraysOfManyKinds {
    public static void main(String[] arguments) {
        long[] longs = new long[3];
        longs[2] = 1L << 40;
        System.out.println(longs[0] + " " + longs[2]); // expect 0 1099511627776
        double[][] grid = new double[3][4];
        grid[1][2] = 0.5;
        grid[2] = new double[] {1, 2};
        System.out.println(grid[1][2] + " " + grid[2].length + " " + grid.length); // expect 0.5 2 3
        int[][] jagged = {{1}, {2, 3}, {}};
        int sum = 0;
        for (int[] row : jagged) {
            for (int number : row) sum += number;
        }
        System.out.println(sum); // expect 6
        int[] copy = jagged[1].clone();
        copy[0] = 9;
        System.out.println(jagged[1][0] + " " + copy[0]); // expect 2 9
        int[][] shallow = jagged.clone();
        shallow[0][0] = 7;
        System.out.println(jagged[0][0]); // expect 7
        byte[] bytes = {127};
        bytes[0]++;
        System.out.println(bytes[0]); // expect -128
        char[] letters = {'a'};
        letters[0] += 2;
        System.out.println(letters[0]); // expect c
        short[] shorts = {(short) 40000};
        System.out.println(shorts[0]); // expect -25536
        boolean[] flags = new boolean[2];
        flags[1] ^= true;
        System.out.println(flags[0] + " " + flags[1]); // expect false true
        String[][][] cube = new String[2][3][];
        System.out.println(cube[1][2] == null); // expect true
        Object thing = longs;
        System.out.println(thing instanceof long[]); // expect true
        System.out.println(thing instanceof Object[]); // expect false
        System.out.println((Object) cube instanceof Object[][]); // expect true
        Object[] things = new Integer[] {1, 2};
        System.out.println(things.length + " " + things[1]); // expect 2 2
        int[] large = new int[5000];
        for (int i = 0; i < large.length; i++) large[i] = i * i;
        System.out.println(large[4999]); // expect 24990001
        int place = 0;
        int[] order = new int[3];
        order[place++] = place++;
        order[place] = place = 1;
        System.out.println(order[0] + " " + order[1] + " " + order[2] + " " + place); // expect 1 0 1 1
        System.arraycopy(large, 10, large, 11, 5);
        System.out.println(large[11] + " " + large[15] + " " + large[16]); // expect 100 196 256
        try {
            large[5000] = 1;
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println("outside"); // expect outside
        }
    }
}
