public class Daemons {
    static volatile int laps;

    public static void main(String[] arguments) throws InterruptedException {
        Thread daemon = new Thread() {
            @Override
            public void run() {
                while (true) {
                    laps++;
                    Thread.yield();
                }
            }
        };
        daemon.setDaemon(true);
        System.out.println(daemon.isDaemon() + " " + Thread.currentThread().isDaemon()); // expect true false
        daemon.start();
        while (laps < 10) Thread.sleep(5);
        System.out.println("runs"); // expect runs
        System.out.println(daemon.getPriority() + " " + Thread.currentThread().getPriority()); // expect 5 5
        daemon.setPriority(Thread.MIN_PRIORITY);
        System.out.println(daemon.getPriority()); // expect 1
        try {
            daemon.setPriority(11);
        } catch (IllegalArgumentException wrong) {
            System.out.println("too important"); // expect too important
        }
    }
}
