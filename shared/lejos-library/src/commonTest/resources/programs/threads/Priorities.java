import josx.platform.rcx.LCD;

public class Priorities extends Thread {
    static boolean isBusy = true;
    private final int number;

    Priorities(int number, int priority) {
        this.number = number;
        setPriority(priority);
    }

    public void run() {
        LCD.showNumber(number); // shows: 7 5 2
    }

    public static void main(String[] arguments) throws InterruptedException {
        LCD.showNumber(Thread.currentThread().getPriority()); // shows: 5
        LCD.showNumber(Thread.NORM_PRIORITY + Thread.MIN_PRIORITY + Thread.MAX_PRIORITY); // shows: 16
        Thread.currentThread().setPriority(Thread.MAX_PRIORITY);
        new Priorities(2, 2).start();
        new Priorities(7, 7).start();
        new Priorities(5, 5).start();
        LCD.showNumber(Thread.currentThread().getPriority()); // shows: 10
        Thread.sleep(100);
    }
}
// ends at 100
