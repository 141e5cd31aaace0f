public class TooManyThreads extends Thread {
    public void run() {
        while (true) Thread.yield();
    }

    public static void main(String[] arguments) {
        while (true) {
            new TooManyThreads().start();
        }
    }
}
// fails 8 OutOfMemoryError
// runs on after 300
