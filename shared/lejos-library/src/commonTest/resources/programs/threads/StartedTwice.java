public class StartedTwice extends Thread {
    public void run() {
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread thread = new StartedTwice();
        thread.start();
        Thread.sleep(100);
        thread.start();
    }
}
// fails 9 IllegalStateException
