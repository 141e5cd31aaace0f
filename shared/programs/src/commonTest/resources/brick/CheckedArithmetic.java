import josx.platform.rcx.LCD;

/** On a brick, an ArithmeticException must be announced, and is none of the exceptions that need not be. */
public class CheckedArithmetic {
    static int half(int number) {
        if (number % 2 != 0) throw new ArithmeticException(); // brick error: throws
        return number / 2;
    }

    static int divided(int number, int by) {
        try {
            return number / by;
        } catch (ArithmeticException zero) { // brick error: Exception instead
            return 0;
        }
    }

    public static void main(String[] args) throws InterruptedException {
        LCD.showNumber(half(8) + divided(8, 0));
        Thread.sleep(2000);
    }
}
// forgiving display: 0004 0
