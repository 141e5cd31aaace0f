import josx.platform.rcx.LCD;
import josx.platform.rcx.Poll;

public class Polls {
    static int bytesOf(short mask) {
        return 2;
    }

    static int bytesOf(int mask) {
        return 4;
    }

    public static void main(String[] arguments) throws InterruptedException {
        LCD.showNumber(bytesOf(Poll.SENSOR1_MASK) + bytesOf(Poll.SERIAL_SHIFT)); // shows: 4
        Thread.sleep(100);
        Poll poll = new Poll();
        poll.setThrottle(1);
        poll.poll(Poll.ALL_SENSORS | Poll.ALL_BUTTONS, 1);
        LCD.showNumber(poll.poll(Poll.SENSOR1_MASK, 50)); // shows: 0
        LCD.showNumber(poll.poll(Poll.ALL_SENSORS, 0)); // shows: 1
        LCD.showNumber(poll.poll(Poll.VIEW_MASK | Poll.RUN_MASK, 0)); // shows: 16
        LCD.showNumber(poll.poll(Poll.PRGM_MASK | Poll.SERIAL_MASK, 10)); // shows: 0
    }
}
// sensor 1 at 300: raw 500
// button VIEW at 400: pressed
// button VIEW at 450: released
// ends at 410
