import josx.platform.rcx.LCD;
import josx.robotics.Activity;
import josx.robotics.StopException;

public class Activities {
    static class Background extends Activity {
        protected void resetRunnable() {
            super.resetRunnable();
            iWantToRun();
        }

        protected void action() throws StopException {
            LCD.showNumber(1); // shows: 1 1
            while (true) {
                try {
                    pause(1000);
                } catch (InterruptedException again) {
                    LCD.showNumber(9);
                }
            }
        }
    }

    static class Urgent extends Activity {
        void go() {
            iWantToRun();
        }

        protected void action() throws StopException {
            LCD.showNumber(2); // shows: 2
            boolean isDone = false;
            while (!isDone) {
                try {
                    pause(100);
                    isDone = true;
                } catch (InterruptedException again) {
                    // The wish to run may be noticed late.
                }
            }
            LCD.showNumber(3); // shows: 3
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Background background = new Background();
        Urgent urgent = new Urgent();
        background.setPriority(3);
        urgent.setPriority(6);
        background.start();
        urgent.start();
        Thread.sleep(100);
        urgent.go();
        Thread.sleep(500);
    }
}
// ends at 600
