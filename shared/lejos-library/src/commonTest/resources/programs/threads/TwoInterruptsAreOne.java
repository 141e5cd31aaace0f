import josx.platform.rcx.LCD;

/** A sleeping thread of which nobody hears in between gets one exception for two interrupts. */
public class TwoInterruptsAreOne extends Thread {
    public void run() {
        for (int sleep = 1; sleep <= 2; sleep++) {
            try {
                sleep(100);
                LCD.showNumber(sleep); // brick shows: 2
            } catch (InterruptedException woken) {
                LCD.showNumber(10 + sleep); // brick shows: 11 // forgiving shows: 11 12
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread sleeper = new TwoInterruptsAreOne();
        sleeper.start();
        Thread.sleep(50);
        sleeper.interrupt();
        sleeper.interrupt();
    }
}
