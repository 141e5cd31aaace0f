import josx.platform.rcx.LCD;

public class WaitAndNotify {
    static final Object bell = new Object();
    static int message = 0;

    static class Sender extends Thread {
        public void run() {
            try {
                Thread.sleep(200);
            } catch (InterruptedException never) {
                return;
            }
            synchronized (bell) {
                message = 7;
                bell.notify();
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new Sender().start();
        synchronized (bell) {
            while (message == 0) bell.wait();
            LCD.showNumber(message); // shows: 7
            bell.wait(100);
        }
        try {
            bell.notifyAll();
        } catch (IllegalMonitorStateException notSynchronized) {
            LCD.showNumber(1); // shows: 1
        }
    }
}
// ends at 300
