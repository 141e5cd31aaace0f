import josx.platform.rcx.LCD;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class ArbitratorLetsTheActionEnd {
    /** Does not care that it is suppressed. */
    static class Stubborn implements Behavior {
        public boolean takeControl() {
            return true;
        }

        public void action() {
            LCD.showNumber(1); // shows: 1
            try {
                Thread.sleep(500);
            } catch (InterruptedException never) {
                LCD.showNumber(9);
            }
            LCD.showNumber(3); // shows: 3
        }

        public void suppress() {
            LCD.showNumber(2); // shows: 2
        }
    }

    static class Urgent implements Behavior {
        public boolean takeControl() {
            return (int) System.currentTimeMillis() >= 100;
        }

        public void action() {
            LCD.showNumber(4); // shows: 4
            System.exit(0);
        }

        public void suppress() {
        }
    }

    public static void main(String[] arguments) {
        new Arbitrator(new Behavior[] {new Stubborn(), new Urgent()}).start();
    }
}
// ends at 500
