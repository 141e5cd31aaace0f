public class DaemonsEndWithTheProgram extends Thread {
    public void run() {
        while (true) Thread.yield();
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread daemon = new DaemonsEndWithTheProgram();
        daemon.setDaemon(true);
        if (!daemon.isDaemon() || Thread.currentThread().isDaemon()) throw new Error("daemon");
        daemon.start();
        Thread.sleep(200);
    }
}
// ends at 200
