import java.util.Arrays;
import java.util.Random;

public class RandomsAndArrays {
    public static void main(String[] arguments) {
        Random random = new Random(42);
        int[] dice = new int[6];
        for (int i = 0; i < 600; i++) dice[random.nextInt(6)]++;
        int sum = 0;
        for (int count : dice) sum += count;
        System.out.println(sum); // expect 600
        int[] numbers = new int[100];
        for (int i = 0; i < numbers.length; i++) numbers[i] = random.nextInt(1000);
        Arrays.sort(numbers);
        boolean isSorted = true;
        for (int i = 1; i < numbers.length; i++) isSorted &= numbers[i - 1] <= numbers[i];
        System.out.println(isSorted); // expect true
        double[] values = {3.5, -0.0, 0.0, 1e-3, -7};
        Arrays.sort(values);
        for (double value : values) System.out.println(value); // expect -7.0
        // expect -0.0
        // expect 0.0
        // expect 0.001
        // expect 3.5
        char[] letters = "robot".toCharArray();
        Arrays.sort(letters, 1, 4);
        System.out.println(new String(letters)); // expect rboot
    }
}
