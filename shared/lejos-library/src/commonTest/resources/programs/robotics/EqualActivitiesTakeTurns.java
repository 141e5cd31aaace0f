import josx.platform.rcx.LCD;
import josx.robotics.Activity;
import josx.robotics.StopException;

public class EqualActivitiesTakeTurns extends Activity {
    private final int number;

    EqualActivitiesTakeTurns(int number) {
        this.number = number;
    }

    protected void resetRunnable() {
        super.resetRunnable();
        iWantToRun();
    }

    protected void action() throws StopException {
        LCD.showNumber(number); // shows: 1 2 1 2
        try {
            pause(100);
        } catch (InterruptedException never) {
            LCD.showNumber(9);
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new EqualActivitiesTakeTurns(1).start();
        new EqualActivitiesTakeTurns(2).start();
        Thread.sleep(350);
    }
}
// ends at 350
