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
        System.out.println(workers[0].isAlive()); // prints: false
        for (Thread worker : workers) worker.start();
        for (Thread worker : workers) worker.join();
        System.out.println(total); // prints: 79800
        System.out.println(workers[0].isAlive()); // prints: false
        Thread slow = new Thread() {
            @Override
            public void run() {
                try {
                    Thread.sleep(300);
                } catch (InterruptedException woken) {
                    System.out.println("woken"); // prints: woken
                }
            }
        };
        slow.start();
        slow.join(50);
        System.out.println(slow.isAlive()); // prints: true
        slow.interrupt();
        slow.join();
        System.out.println(slow.isAlive()); // prints: false
        System.out.println(Thread.currentThread().isInterrupted()); // prints: false
        Thread.currentThread().interrupt();
        try {
            Thread.sleep(10);
        } catch (InterruptedException woken) {
            System.out.println("at once"); // prints: at once
        }
        System.out.println(Thread.interrupted()); // prints: false
        try {
            slow.start(); // fails IllegalThreadStateException
        } catch (IllegalStateException wrong) {
            System.out.println("twice");
        }
    }
}
