import josx.platform.rcx.LCD;

/** A thread that is interrupted and then sleeps gives its turn away before it gets the exception. */
public class InterruptsWaitForTheTurn extends Thread {
    static int turns = 0;

    public void run() {
        while (turns < 20) {
            turns++;
            Thread.yield();
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new InterruptsWaitForTheTurn().start();
        for (int turn = 0; turn < 5; turn++) Thread.yield();
        currentThread().interrupt();
        int before = turns;
        try {
            sleep(50);
        } catch (InterruptedException late) {
            LCD.showNumber(turns - before); // brick shows: 1 // forgiving shows: 0
        }
        LCD.showNumber(currentThread().isInterrupted() ? 2 : 3); // shows: 3
    }
}
