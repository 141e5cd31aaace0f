import josx.platform.rcx.LCD;

public class NegativeTimes {
    public static void main(String[] arguments) throws InterruptedException {
        Thread.sleep(100);
        try {
            Thread.sleep(-20);
            LCD.showNumber(1); // brick shows: 1
        } catch (IllegalArgumentException onlyOnAComputer) {
            LCD.showNumber(2); // forgiving shows: 2
        }
        Object lock = new Object();
        synchronized (lock) {
            try {
                lock.wait(-20);
                LCD.showNumber(3); // brick shows: 3
            } catch (IllegalArgumentException onlyOnAComputer) {
                LCD.showNumber(4); // forgiving shows: 4
            }
        }
    }
}
// ends at 100
