public class Joining {
    static int total;

    public static void main(String[] arguments) throws InterruptedException {
        Thread[] workers = new Thread[4];
        for (int i = 0; i < workers.length; i++) {
            final int from = i * 100;
            workers[i] = new Thread(new Runnable() {
                public void run() {
                    int sum = 0;
                    for (int n = from; n < from + 100; n++) sum += n;
                    synchronized (Joining.class) {
                        total += sum;
                    }
                }
            });
        }
        System.out.println(workers[0].isAlive());
        for (Thread worker : workers) worker.start();
        for (Thread worker : workers) worker.join();
        System.out.println(total);
        System.out.println(workers[0].isAlive());
        Thread slow = new Thread() {
            @Override
            public void run() {
                try {
                    Thread.sleep(300);
                } catch (InterruptedException woken) {
                    System.out.println("woken");
                }
            }
        };
        slow.start();
        slow.join(50);
        System.out.println(slow.isAlive());
        slow.interrupt();
        slow.join();
        System.out.println(slow.isAlive());
        System.out.println(Thread.currentThread().isInterrupted());
        Thread.currentThread().interrupt();
        try {
            Thread.sleep(10);
        } catch (InterruptedException woken) {
            System.out.println("at once");
        }
        System.out.println(Thread.interrupted());
    }
}

// It prints:
// expect false
// expect 79800
// expect false
// expect true
// expect woken
// expect false
// expect false
// expect at once
// expect false
