import java.util.Random;
import josx.platform.rcx.LCD;

public class RandomNumbers {
    public static void main(String[] arguments) {
        Random first = new Random(5);
        Random second = new Random(5);
        LCD.showNumber(first.nextInt() == 241354 ? 1 : 0); // shows: 1
        LCD.showNumber(second.nextInt(10)); // shows: 4
        LCD.showNumber(first.nextInt() == second.nextInt() ? 1 : 0); // shows: 1
        boolean isInside = true;
        for (int times = 0; times < 100; times++) {
            int die = first.nextInt(6);
            if (die < 0 || die > 5) isInside = false;
        }
        LCD.showNumber(isInside ? 1 : 0); // shows: 1
        try {
            first.nextInt(-6);
        } catch (IllegalArgumentException notAboveZero) {
            LCD.showNumber(2); // shows: 2
        }
        new Random().nextInt();
    }
}
