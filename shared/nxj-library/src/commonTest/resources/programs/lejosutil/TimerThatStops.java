import lejos.util.Timer;
import lejos.util.TimerListener;

// A timer that is stopped while it waits calls its listener once more, as with leJOS NXJ.
// only here
public class TimerThatStops {
    private static int ticks;

    public static void main(String[] arguments) throws InterruptedException {
        Timer timer = new Timer(30, new TimerListener() {
            public void timedOut() {
                ticks++;
            }
        });
        timer.start();
        Thread.sleep(45);
        timer.stop();
        System.out.println(ticks); // expect 1
        Thread.sleep(100);
        System.out.println(ticks); // expect 2
        timer.start();
        Thread.sleep(50);
        System.out.println(ticks); // expect 3
    }
}
