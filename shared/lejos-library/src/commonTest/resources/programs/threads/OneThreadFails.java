public class OneThreadFails extends Thread {
    public void run() {
        String nothing = null;
        nothing.length();
    }

    public static void main(String[] arguments) throws InterruptedException {
        new OneThreadFails().start();
        Thread.sleep(100);
    }
}
// fails 4 NullPointerException
