import josx.platform.rcx.LCD;

/** A thread that has its first turn gets a second one before the next thread has its first. */
public class FirstTurnsAreDouble extends Thread {
    private final int hundreds;

    FirstTurnsAreDouble(int hundreds) {
        this.hundreds = hundreds;
    }

    public void run() {
        for (int turn = 1; turn <= 3; turn++) {
            LCD.showNumber(hundreds + turn); // brick shows: 101 102 201 202 103 203 // forgiving shows: 101 201 102 202 103 203
            Thread.yield();
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new FirstTurnsAreDouble(100).start();
        new FirstTurnsAreDouble(200).start();
        Thread.sleep(200);
    }
}
