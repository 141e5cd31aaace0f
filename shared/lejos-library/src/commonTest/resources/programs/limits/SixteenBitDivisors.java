// mode: brick
import josx.platform.rcx.LCD;

public class SixteenBitDivisors {
    public static void main(String[] arguments) {
        int divisor = 70000;
        LCD.showNumber(100000 / divisor); // shows: 22
        LCD.showNumber(100000 % divisor); // shows: 1792
        divisor = 65536;
        LCD.showNumber(100000 / divisor);
    }
}
// fails 10 ArithmeticException
