import java.util.Timer;
import java.util.TimerTask;

public class TimersOfJava {
    static volatile int ticks;
    static volatile boolean once;

    public static void main(String[] arguments) throws InterruptedException {
        Timer timer = new Timer(true);
        timer.schedule(new TimerTask() {
            @Override
            public void run() {
                once = true;
            }
        }, 10);
        timer.schedule(new TimerTask() {
            @Override
            public void run() {
                ticks++;
                if (ticks == 3) cancel();
            }
        }, 5, 10);
        while (ticks < 3 || !once) Thread.sleep(5);
        Thread.sleep(40);
        System.out.println(ticks + " " + once); // expect 3 true
        timer.cancel();
        try {
            timer.schedule(new TimerTask() {
                @Override
                public void run() {
                }
            }, 1);
        } catch (IllegalStateException wrong) {
            System.out.println("cancelled"); // expect cancelled
        }
    }
}
