import josx.platform.rcx.LCD;
import josx.robotics.Arbitrator;
import josx.robotics.Behavior;

public class ArbitratorWaitsForTheMoreImportant implements Behavior {
    private final int number;
    private final int first;
    private final int last;

    /** Wants the robot from one moment to another. */
    ArbitratorWaitsForTheMoreImportant(int number, int first, int last) {
        this.number = number;
        this.first = first;
        this.last = last;
    }

    public boolean takeControl() {
        int now = (int) System.currentTimeMillis();
        return now >= first && now < last;
    }

    public void action() {
        LCD.showNumber(number); // shows: 0 1 0 2
        if (number == 2) System.exit(0);
        if (number == 0) return;
        try {
            Thread.sleep(300);
        } catch (InterruptedException never) {
            LCD.showNumber(9);
        }
    }

    public void suppress() {
        LCD.showNumber(10 + number); // shows: 10 11 10
    }

    public static void main(String[] arguments) {
        int now = (int) System.currentTimeMillis();
        new Arbitrator(new Behavior[] {
            new ArbitratorWaitsForTheMoreImportant(0, now, now + 9999),
            new ArbitratorWaitsForTheMoreImportant(1, now + 100, now + 150),
            new ArbitratorWaitsForTheMoreImportant(2, now + 200, now + 9999),
        }).start();
    }
}
