/** Threads that wait for each other. */
public class Joined {
    static int count;
    static final Object LOCK = new Object();
    static StringBuffer told = new StringBuffer();

    static class Counter extends Thread {
        public void run() {
            for (int i = 0; i < 1000; i++) {
                synchronized (LOCK) {
                    count++;
                }
                if (i % 100 == 0) Thread.yield();
            }
        }
    }

    public static void main(String[] args) throws InterruptedException {
        Thread[] threads = new Thread[4];
        for (int i = 0; i < threads.length; i++) {
            threads[i] = new Counter();
            threads[i].start();
        }
        for (Thread thread : threads) thread.join();
        System.out.println(count); // expect 4000
        Thread sleeper = new Thread(new Runnable() {
            public void run() {
                try {
                    Thread.sleep(100000);
                } catch (InterruptedException e) {
                    told.append("woken ");
                }
            }
        });
        sleeper.start();
        Thread.sleep(50);
        sleeper.join(20);
        System.out.println(sleeper.isAlive()); // expect true
        sleeper.interrupt();
        sleeper.join();
        System.out.println(told.toString() + sleeper.isAlive()); // expect woken false
        final boolean[] ready = new boolean[1];
        Thread waiter = new Thread() {
            public void run() {
                synchronized (LOCK) {
                    while (!ready[0]) {
                        try {
                            LOCK.wait();
                        } catch (InterruptedException e) {
                            return;
                        }
                    }
                    told.append("notified");
                }
            }
        };
        waiter.start();
        Thread.sleep(10);
        synchronized (LOCK) {
            ready[0] = true;
            LOCK.notifyAll();
        }
        waiter.join();
        System.out.println(told); // expect woken notified
        synchronized (LOCK) {
            long before = System.currentTimeMillis();
            LOCK.wait(30);
            long waited = System.currentTimeMillis() - before;
            System.out.println(waited >= 30 && waited < 60); // expect true
        }
        try {
            LOCK.notify();
        } catch (IllegalMonitorStateException e) {
            System.out.println("not mine"); // expect not mine
        }
        Thread daemon = new Thread() {
            public void run() {
                while (true) Thread.yield();
            }
        };
        daemon.setDaemon(true);
        daemon.start();
    }
}
