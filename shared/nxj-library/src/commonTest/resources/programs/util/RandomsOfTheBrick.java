// only here
import java.util.Random;

/** A brick makes random numbers in its own way. */
public class RandomsOfTheBrick {
    public static void main(String[] arguments) {
        Random random = new Random(2);
        System.out.println(random.nextInt()); // expect 96543
        System.out.println(random.nextInt()); // expect 365259859
        System.out.println(random.nextInt(1000) + " " + new Random(2).nextInt(1000)); // expect 850 543
        for (int seed = 0; seed < 3; seed++) {
            Random coin = new Random(seed);
            String shown = "";
            for (int i = 0; i < 9; i++) shown += coin.nextBoolean() ? "1" : "0";
            System.out.println(shown);
        }
        // expect 110110110
        // expect 011011011
        // expect 110110110
        int[] dice = new int[6];
        for (int i = 0; i < 600; i++) dice[random.nextInt(6)]++;
        int fewest = 600;
        for (int count : dice) fewest = Math.min(fewest, count);
        System.out.println(fewest > 20); // expect true
        boolean isInside = true;
        double sum = 0;
        for (int i = 0; i < 300; i++) {
            double number = random.nextDouble();
            float small = random.nextFloat();
            isInside &= number >= 0 && number < 1 && small >= 0 && small < 1;
            sum += random.nextGaussian();
        }
        System.out.println(isInside + " " + (Math.abs(sum) < 100)); // expect true true
        System.out.println(new Random(5L << 32).nextInt() == new Random(0).nextInt()); // expect true
    }
}
