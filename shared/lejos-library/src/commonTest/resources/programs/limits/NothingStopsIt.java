public class NothingStopsIt extends Thread {
    public void run() {
        while (true) {
            try {
                int[] numbers = new int[2];
                while (true) numbers[2] = 1;
            } catch (Throwable again) {
                continue;
            } finally {
                Thread.yield();
            }
        }
    }

    public static void main(String[] arguments) {
        new NothingStopsIt().start();
    }
}
// mode: forgiving
// runs on after 2000
