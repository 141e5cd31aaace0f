import josx.platform.rcx.LCD;

public class NotifyAllWakesAll extends Thread {
    static final Object gate = new Object();
    static int awake = 0;

    public void run() {
        synchronized (gate) {
            try {
                gate.wait();
            } catch (InterruptedException never) {
                return;
            }
            awake++;
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        for (int count = 0; count < 3; count++) new NotifyAllWakesAll().start();
        Thread.sleep(50);
        synchronized (gate) {
            gate.notifyAll();
            LCD.showNumber(awake); // shows: 0
        }
        Thread.sleep(50);
        LCD.showNumber(awake); // shows: 3
    }
}
// ends at 100
