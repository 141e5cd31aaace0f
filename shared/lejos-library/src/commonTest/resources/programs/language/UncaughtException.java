import josx.platform.rcx.LCD;

public class UncaughtException {
    static int divide(int a, int b) {
        return a / b;
    }

    public static void main(String[] arguments) {
        LCD.showNumber(divide(8, 2)); // shows: 4
        LCD.showNumber(divide(8, 0));
    }
}
// fails 5 ArithmeticException
