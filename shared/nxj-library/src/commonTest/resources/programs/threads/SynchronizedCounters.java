public class SynchronizedCounters {
    private int value;
    private static int shared;

    synchronized void add() {
        int old = value;
        Thread.yield();
        value = old + 1;
    }

    static synchronized void addShared() {
        int old = shared;
        Thread.yield();
        shared = old + 1;
    }

    private synchronized int twice() {
        add();
        synchronized (this) {
            add();
        }
        return value;
    }

    public static void main(String[] arguments) throws InterruptedException {
        final SynchronizedCounters counter = new SynchronizedCounters();
        Runnable counting = new Runnable() {
            public void run() {
                for (int i = 0; i < 100; i++) {
                    counter.add();
                    addShared();
                }
            }
        };
        Thread first = new Thread(counting);
        Thread second = new Thread(counting);
        first.start();
        second.start();
        first.join();
        second.join();
        System.out.println(counter.value + " " + shared); // expect 200 200
        System.out.println(counter.twice()); // expect 202
    }
}
