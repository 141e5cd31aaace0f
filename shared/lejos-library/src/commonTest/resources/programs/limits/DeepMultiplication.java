import josx.platform.rcx.LCD;

public class DeepMultiplication {
    public static void main(String[] arguments) {
        int number = 48271;
        for (int times = 0; times < 3; times++) number *= 48271;
        LCD.showNumber(number == 48271 * 48271 * 48271 * 48271 ? 1 : 0); // shows: 1
        LCD.showNumber(Integer.MIN_VALUE / -1 == Integer.MIN_VALUE ? 1 : 0); // shows: 1
    }
}
