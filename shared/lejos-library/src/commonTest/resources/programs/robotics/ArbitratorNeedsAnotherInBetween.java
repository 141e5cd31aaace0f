import josx.platform.rcx.LCD;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class ArbitratorNeedsAnotherInBetween implements Behavior {
    public boolean takeControl() {
        int now = (int) System.currentTimeMillis();
        if (now >= 400) System.exit(0);
        return now < 100 || now >= 200;
    }

    public void action() {
        LCD.showNumber(1); // shows: 1
    }

    public void suppress() {
        LCD.showNumber(2);
    }

    public static void main(String[] arguments) {
        new Arbitrator(new Behavior[] {new ArbitratorNeedsAnotherInBetween()}).start();
    }
}
// ends at 400
