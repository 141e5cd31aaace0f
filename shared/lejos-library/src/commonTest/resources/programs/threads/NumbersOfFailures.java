import josx.platform.rcx.LCD;

/** The numbers of main and run, and of the exceptions of the machine itself, are the same in every program. */
public class NumbersOfFailures extends Thread {
    private final int kind;

    NumbersOfFailures(int kind) {
        this.kind = kind;
    }

    public void run() {
        String nothing = null;
        Object number = new Integer(3);
        int[] numbers = {1, 2};
        if (kind == 4) throw new Error();
        if (kind == 5) LCD.showNumber(new int[-1].length);
        if (kind == 8) nothing.length();
        if (kind == 9) ((String) number).length();
        if (kind == 10) LCD.showNumber(8 / (kind - 10));
        if (kind == 11) LCD.showNumber(numbers[kind]);
        if (kind == 12) setPriority(99);
        if (kind == 14) start();
        if (kind == 15) notify();
        if (kind == 16) throw new ThreadDeath();
    }

    public static void main(String[] arguments) throws InterruptedException {
        int[] kinds = {4, 5, 8, 9, 10, 11, 12, 14, 15, 16};
        for (int index = 0; index < kinds.length; index++) {
            new NumbersOfFailures(kinds[index]).start();
            Thread.sleep(10);
        }
        Thread.currentThread().interrupt();
        Thread.sleep(10);
    }
}
// fails 15 Error shows 1 4
// fails 16 OutOfMemoryError shows 1 5
// fails 17 NullPointerException shows 1 8
// fails 18 ClassCastException shows 1 9
// fails 19 ArithmeticException shows 1 10
// fails 20 ArrayIndexOutOfBoundsException shows 1 11
// fails 21 IllegalArgumentException shows 1 12
// fails 22 IllegalStateException shows 1 14
// fails 23 IllegalMonitorStateException shows 1 15
// fails 34 InterruptedException shows 0 13
