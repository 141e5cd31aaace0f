import josx.platform.rcx.LCD;

public class SixteenBitDivisors {
    public static void main(String[] arguments) {
        int divisor = 70000;
        LCD.showNumber(100000 / divisor); // brick shows: 22 // forgiving shows: 1
        LCD.showNumber(100000 % divisor / 10); // brick shows: 179 // forgiving shows: 3000
        divisor = 65536;
        LCD.showNumber(100000 / divisor); // forgiving shows: 1
    }
}
// brick fails 9 ArithmeticException
