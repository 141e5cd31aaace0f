public class DeadlockFree {
    static class Account {
        private int money = 100;

        synchronized void change(int amount) {
            money += amount;
        }

        synchronized int money() {
            return money;
        }
    }

    static final Account[] ACCOUNTS = {new Account(), new Account(), new Account()};

    static void move(int from, int to, int amount) {
        Account first = ACCOUNTS[Math.min(from, to)];
        Account second = ACCOUNTS[Math.max(from, to)];
        synchronized (first) {
            Thread.yield();
            synchronized (second) {
                ACCOUNTS[from].change(-amount);
                ACCOUNTS[to].change(amount);
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread[] movers = new Thread[3];
        for (int i = 0; i < movers.length; i++) {
            final int from = i;
            movers[i] = new Thread() {
                @Override
                public void run() {
                    for (int n = 0; n < 30; n++) move(from, (from + 1) % 3, from + 1);
                }
            };
            movers[i].start();
        }
        for (Thread mover : movers) mover.join();
        System.out.println(ACCOUNTS[0].money() + " " + ACCOUNTS[1].money() + " " + ACCOUNTS[2].money()); // expect 160 70 70
        synchronized (ACCOUNTS) {
            synchronized (ACCOUNTS) {
                ACCOUNTS[0].change(1);
            }
        }
        System.out.println(ACCOUNTS[0].money()); // expect 161
    }
}
