/** Methods that are synchronized in name only on a brick. */
public class UnlockedMethods {
    private int count;

    private synchronized void add() { // warning: synchronized (this)
        count++;
    }

    private synchronized void awaitOne() throws InterruptedException { // warning: IllegalMonitorStateException
        while (count == 0) wait();
    }

    static synchronized int twice(int number) { // warning: synchronized (LOCK)
        return 2 * number;
    }

    synchronized void start() throws InterruptedException {
        add();
        awaitOne();
    }

    static class Quiet extends UnlockedMethods {
        void start() throws InterruptedException {
            super.start(); // warning: "super"
        }
    }

    public static void main(String[] args) throws InterruptedException {
        new UnlockedMethods().start();
        twice(2);
    }
}
