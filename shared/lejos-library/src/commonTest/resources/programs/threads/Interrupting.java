import josx.platform.rcx.LCD;

public class Interrupting extends Thread {
    public void run() {
        try {
            Thread.sleep(10000);
            LCD.showNumber(1);
        } catch (InterruptedException woken) {
            LCD.showNumber(2); // shows: 2
        }
        LCD.showNumber(isInterrupted() ? 1 : 0); // shows: 0
        while (!isInterrupted()) Thread.yield();
        LCD.showNumber(Thread.interrupted() ? 1 : 0); // shows: 1
        LCD.showNumber(Thread.interrupted() ? 1 : 0); // shows: 0
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread sleeper = new Interrupting();
        sleeper.start();
        Thread.sleep(100);
        sleeper.interrupt();
        Thread.sleep(100);
        sleeper.interrupt();
    }
}
// ends at 200
