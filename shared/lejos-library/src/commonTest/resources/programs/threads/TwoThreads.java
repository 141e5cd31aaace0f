import josx.platform.rcx.LCD;

public class TwoThreads extends Thread {
    public void run() {
        for (int count = 0; count < 3; count++) {
            LCD.showNumber(100 + count); // shows: 100 101 102
            try {
                Thread.sleep(100);
            } catch (InterruptedException never) {
                return;
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread other = new TwoThreads();
        LCD.showNumber(other.isAlive() ? 1 : 0); // shows: 0
        other.start();
        LCD.showNumber(other.isAlive() ? 1 : 0); // shows: 1
        Thread.sleep(50);
        for (int count = 0; count < 2; count++) {
            LCD.showNumber(200 + count); // shows: 200 201
            Thread.sleep(100);
        }
        Thread.sleep(100);
        LCD.showNumber(other.isAlive() ? 1 : 0); // shows: 0
    }
}
// ends at 350
