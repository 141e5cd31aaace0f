public class NoRunnable implements Runnable {
    public void run() {
    }

    public static void main(String[] arguments) {
        new Thread(new NoRunnable()).start();
    }
}
// error 1
// error 6
