import josx.platform.rcx.LCD;

public class LongIsOnlyForTheClock {
    public static void main(String[] arguments) throws InterruptedException {
        long began = System.currentTimeMillis();
        Thread.sleep(100);
        int passed = (int) System.currentTimeMillis() - (int) began;
        LCD.showNumber(passed / 50); // shows: 2
    }
}
// ends at 100
