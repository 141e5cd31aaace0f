public class Philosophers {
    static final Object[] FORKS = new Object[5];
    static final int[] MEALS = new int[5];

    static class Philosopher extends Thread {
        private final int seat;

        Philosopher(int seat) {
            this.seat = seat;
        }

        @Override
        public void run() {
            int left = seat;
            int right = (seat + 1) % FORKS.length;
            for (int meal = 0; meal < 20; meal++) {
                synchronized (FORKS[Math.min(left, right)]) {
                    Thread.yield();
                    synchronized (FORKS[Math.max(left, right)]) {
                        MEALS[seat]++;
                    }
                }
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Philosopher[] philosophers = new Philosopher[FORKS.length];
        for (int i = 0; i < FORKS.length; i++) FORKS[i] = new Object();
        for (int i = 0; i < FORKS.length; i++) philosophers[i] = new Philosopher(i);
        for (Philosopher philosopher : philosophers) philosopher.start();
        for (Philosopher philosopher : philosophers) philosopher.join();
        int sum = 0;
        for (int meals : MEALS) sum += meals;
        System.out.println(sum); // expect 100
    }
}
