import josx.platform.rcx.LCD;

public class HighPriorityStarvesOthers extends Thread {
    static int turns = 0;

    public void run() {
        while (true) turns++;
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread low = new HighPriorityStarvesOthers();
        low.setPriority(Thread.MIN_PRIORITY);
        low.setDaemon(true);
        low.start();
        int end = (int) System.currentTimeMillis() + 300;
        while (end - (int) System.currentTimeMillis() > 0) Thread.yield();
        LCD.showNumber(turns); // shows: 0
        Thread.sleep(100);
        LCD.showNumber(turns > 0 ? 1 : 0); // shows: 1
    }
}
// ends at 400
