public class WaitAndNotify {
    static class Buffer {
        private final int[] values = new int[3];
        private int count;
        private int first;

        synchronized void put(int value) throws InterruptedException {
            while (count == values.length) wait();
            values[(first + count++) % values.length] = value;
            notifyAll();
        }

        synchronized int take() throws InterruptedException {
            while (count == 0) wait();
            int value = values[first];
            first = (first + 1) % values.length;
            count--;
            notifyAll();
            return value;
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        final Buffer buffer = new Buffer();
        Thread producer = new Thread() {
            @Override
            public void run() {
                try {
                    for (int i = 1; i <= 20; i++) buffer.put(i * i);
                    buffer.put(-1);
                } catch (InterruptedException woken) {
                    System.out.println("never");
                }
            }
        };
        producer.start();
        int sum = 0;
        for (int value = buffer.take(); value >= 0; value = buffer.take()) sum = sum * 3 + value;
        System.out.println(sum); // expect 935209074
        producer.join();
        Object lock = new Object();
        long before = System.currentTimeMillis();
        synchronized (lock) {
            lock.wait(30);
        }
        System.out.println(System.currentTimeMillis() - before >= 30); // expect true
        try {
            lock.notify();
        } catch (IllegalMonitorStateException wrong) {
            System.out.println("not mine"); // expect not mine
        }
        try {
            lock.wait();
        } catch (IllegalMonitorStateException wrong) {
            System.out.println("not mine either"); // expect not mine either
        }
    }
}
