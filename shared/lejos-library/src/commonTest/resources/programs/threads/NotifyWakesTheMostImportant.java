import josx.platform.rcx.LCD;

public class NotifyWakesTheMostImportant extends Thread {
    static final Object GATE = new Object();

    NotifyWakesTheMostImportant(int priority) {
        setPriority(priority);
    }

    public void run() {
        synchronized (GATE) {
            try {
                GATE.wait();
            } catch (InterruptedException never) {
                return;
            }
            LCD.showNumber(getPriority()); // shows: 7 4 4 3
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        int[] priorities = {3, 4, 7, 4};
        for (int index = 0; index < priorities.length; index++) new NotifyWakesTheMostImportant(priorities[index]).start();
        for (int times = 0; times < priorities.length; times++) {
            Thread.sleep(20);
            synchronized (GATE) {
                GATE.notify();
            }
        }
    }
}
