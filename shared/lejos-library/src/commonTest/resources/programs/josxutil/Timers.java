import josx.platform.rcx.LCD;
import josx.util.Timer;
import josx.util.TimerListener;

public class Timers implements TimerListener {
    static int ticks = 0;

    public void timedOut() {
        ticks++;
    }

    public static void main(String[] arguments) throws InterruptedException {
        Timer timer = new Timer(100, new Timers());
        Thread.sleep(250);
        LCD.showNumber(ticks); // shows: 0
        timer.start();
        Thread.sleep(350);
        LCD.showNumber(ticks); // shows: 3
        timer.setDelay(200);
        LCD.showNumber(timer.getDelay()); // shows: 200
        timer.stop();
        Thread.sleep(500);
        LCD.showNumber(ticks); // shows: 3
        System.exit(0);
    }
}
// ends at 1100
