import josx.platform.rcx.LCD;

public class NoPriorityInversion {
    static final Object LOCK = new Object();

    static class Unimportant extends Thread {
        public void run() {
            synchronized (LOCK) {
                work(50);
                show(1);
            }
        }
    }

    static class Ordinary extends Thread {
        public void run() {
            work(300);
            show(2);
        }
    }

    static class Important extends Thread {
        public void run() {
            synchronized (LOCK) {
                show(3);
            }
        }
    }

    static void work(int milliseconds) {
        int end = (int) System.currentTimeMillis() + milliseconds;
        while (end - (int) System.currentTimeMillis() > 0) continue;
    }

    static void show(int number) {
        LCD.showNumber(number); // shows: 1 3 2
    }

    static void start(Thread thread, int priority) {
        thread.setPriority(priority);
        thread.start();
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread.currentThread().setPriority(Thread.MAX_PRIORITY);
        start(new Unimportant(), 2);
        Thread.sleep(20); // it has the lock
        start(new Ordinary(), 4);
        start(new Important(), 6);
        Thread.sleep(1000);
    }
}
// ends at 1020
