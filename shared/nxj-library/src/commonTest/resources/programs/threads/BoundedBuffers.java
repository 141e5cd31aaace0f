public class BoundedBuffers {
    private final int[] items = new int[3];
    private int count;
    private int first;
    int waits;

    synchronized void put(int item) throws InterruptedException {
        while (count == items.length) {
            waits++;
            wait();
        }
        items[(first + count++) % items.length] = item;
        notifyAll();
    }

    synchronized int take() throws InterruptedException {
        while (count == 0) wait();
        int item = items[first];
        first = (first + 1) % items.length;
        count--;
        notifyAll();
        return item;
    }

    public static void main(String[] arguments) throws InterruptedException {
        final BoundedBuffers buffer = new BoundedBuffers();
        Thread[] makers = new Thread[2];
        for (int number = 0; number < makers.length; number++) {
            final int from = 100 * number;
            makers[number] = new Thread(new Runnable() {
                public void run() {
                    try {
                        for (int i = 1; i <= 20; i++) buffer.put(from + i);
                    } catch (InterruptedException stopped) {
                        System.out.println("stopped");
                    }
                }
            });
            makers[number].start();
        }
        int sum = 0;
        int lastOfFirst = 0;
        boolean isInOrder = true;
        for (int i = 0; i < 40; i++) {
            int item = buffer.take();
            sum += item;
            if (item < 100) {
                if (item < lastOfFirst) isInOrder = false;
                lastOfFirst = item;
            }
        }
        for (Thread maker : makers) maker.join();
        System.out.println(sum + " " + isInOrder + " " + (buffer.waits > 0));
        // expect 2420 true true
    }
}
