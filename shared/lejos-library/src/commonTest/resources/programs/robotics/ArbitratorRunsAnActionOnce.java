import josx.platform.rcx.LCD;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class ArbitratorRunsAnActionOnce implements Behavior {
    private int actions = 0;

    public boolean takeControl() {
        if ((int) System.currentTimeMillis() > 300) System.exit(0);
        return true;
    }

    public void action() {
        actions++;
        LCD.showNumber(actions); // shows: 1
    }

    public void suppress() {
        LCD.showNumber(100);
    }

    public static void main(String[] arguments) {
        new Arbitrator(new Behavior[] {new ArbitratorRunsAnActionOnce()}).start();
    }
}
// ends at 301
