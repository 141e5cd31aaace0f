import josx.platform.rcx.LCD;
import josx.robotics.Activity;
import josx.robotics.ActivityBase;
import josx.robotics.StopException;

public class ActivitiesPauseForEver {
    /** Is called again once, and gives the robot away in the end. */
    static class Guard extends Activity {
        void wake() {
            iWantToRun();
        }

        protected void action() throws StopException {
            LCD.showNumber(1); // shows: 1
            while (true) {
                try {
                    pause();
                } catch (InterruptedException calledAgain) {
                    LCD.showNumber(2); // shows: 2
                }
            }
        }
    }

    /** Counts how often something happens to the robot, as activities do it themselves: with the monitor of all. */
    static class Watcher extends ActivityBase {
        static int changes;

        public void run() {
            synchronized (monitor) {
                while (true) {
                    try {
                        monitor.wait();
                    } catch (InterruptedException never) {
                        return;
                    }
                    changes++;
                }
            }
        }
    }

    /** Asks for the robot before it has started, and gets it then. */
    static class Urgent extends Activity {
        Urgent() {
            iWantToRun();
        }

        protected void action() throws StopException {
            LCD.showNumber(3); // shows: 3
        }
    }

    /** Counts the seconds and does not keep the program from ending. */
    static class Clock extends ActivityBase {
        static int ticks;

        public void run() {
            while (true) {
                try {
                    sleep(100);
                } catch (InterruptedException never) {
                    return;
                }
                ticks++;
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new Clock().start();
        new Watcher().start();
        Urgent urgent = new Urgent();
        urgent.setPriority(7);
        Guard guard = new Guard();
        guard.setPriority(6);
        guard.wake();
        guard.start();
        Thread.sleep(100);
        guard.wake();
        Thread.sleep(100);
        urgent.start();
        Thread.sleep(150);
        LCD.showNumber(Clock.ticks); // shows: 3
        LCD.showNumber(Watcher.changes >= 2 ? 1 : 0); // shows: 1
    }
}
// ends at 350
