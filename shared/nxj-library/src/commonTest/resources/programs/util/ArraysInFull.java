import java.util.Arrays;

public class ArraysInFull {
    public static void main(String[] arguments) {
        int[] numbers = {5, -3, 8, 0};
        Arrays.sort(numbers);
        System.out.println(Arrays.toString(numbers)); // expect [-3, 0, 5, 8]
        System.out.println(Arrays.binarySearch(numbers, 5) + " " + Arrays.binarySearch(numbers, 6) + " " + Arrays.binarySearch(numbers, 1, 2, 8)); // expect 2 -4 -3
        Arrays.fill(numbers, 1, 3, 7);
        System.out.println(Arrays.toString(numbers) + Arrays.equals(numbers, new int[] {-3, 7, 7, 8})); // expect [-3, 7, 7, 8]true
        System.out.println(Arrays.toString(Arrays.copyOf(numbers, 2)) + Arrays.toString(Arrays.copyOf(numbers, 5))); // expect [-3, 7][-3, 7, 7, 8, 0]
        System.out.println(Arrays.toString(Arrays.copyOfRange(numbers, 3, 6))); // expect [8, 0, 0]
        String[] words = {"turn", "go", "stop"};
        Arrays.sort(words);
        System.out.println(Arrays.toString(words) + Arrays.binarySearch(words, "stop")); // expect [go, stop, turn]1
        Arrays.sort(words, 1, 3);
        Arrays.fill(words, 0, 1, null);
        System.out.println(Arrays.toString(words) + Arrays.equals(words, new String[] {null, "stop", "turn"})); // expect [null, stop, turn]true
        double[] decimals = {2.5, -1, 0.5};
        Arrays.sort(decimals);
        System.out.println(Arrays.toString(decimals) + Arrays.binarySearch(decimals, 0.5)); // expect [-1.0, 0.5, 2.5]1
        boolean[] flags = new boolean[3];
        Arrays.fill(flags, true);
        System.out.println(Arrays.toString(Arrays.copyOf(flags, 4))); // expect [true, true, true, false]
        char[] letters = {'c', 'a', 'b'};
        Arrays.sort(letters);
        System.out.println(Arrays.toString(letters) + Arrays.binarySearch(letters, 'b')); // expect [a, b, c]1
        long[] longs = new long[2];
        Arrays.fill(longs, 1L << 40);
        System.out.println(Arrays.toString(longs) + Arrays.equals(longs, null)); // expect [1099511627776, 1099511627776]false
        float[] floats = {0.5f, 1.5f};
        System.out.println(Arrays.toString(floats) + Arrays.binarySearch(floats, 2f)); // expect [0.5, 1.5]-3
        byte[] bytes = {3, 1};
        short[] shorts = {4, 2};
        Arrays.sort(bytes);
        Arrays.sort(shorts);
        System.out.println(Arrays.toString(bytes) + Arrays.toString(Arrays.copyOf(shorts, 1)) + Arrays.toString((int[]) null)); // expect [1, 3][2]null
        try {
            Arrays.fill(numbers, 3, 1, 0);
        } catch (IllegalArgumentException wrong) {
            System.out.println("backward"); // expect backward
        }
        try {
            Arrays.fill(numbers, 0, 9, 0);
        } catch (ArrayIndexOutOfBoundsException wrong) {
            System.out.println("too far"); // expect too far
        }
    }
}
