public class Synchronized {
    private int count = 0;

    synchronized void add() {
        int before = count;
        Thread.yield();
        count = before + 1;
    }

    static synchronized int twice(int number) {
        return number * 2;
    }

    static class Adder extends Thread {
        private final Synchronized counter;
        static int ready = 0;

        Adder(Synchronized counter) {
            this.counter = counter;
        }

        public void run() {
            for (int times = 0; times < 20; times++) counter.add();
            synchronized (counter) {
                ready++;
                counter.notifyAll();
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Synchronized counter = new Synchronized();
        new Adder(counter).start();
        new Adder(counter).start();
        synchronized (counter) {
            while (Adder.ready < 2) counter.wait();
            synchronized (counter) {
                System.out.println(counter.count); // expect 40
            }
        }
        System.out.println(twice(4)); // expect 8
    }
}
