import josx.platform.rcx.LCD;

public class JoinDoesNothing extends Thread {
    public void run() {
        try {
            Thread.sleep(200);
        } catch (InterruptedException never) {
            return;
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        Thread other = new JoinDoesNothing();
        other.start();
        other.join();
        LCD.showNumber(other.isAlive() ? 1 : 0); // shows: 1
        other.join(1000);
    }
}
// ends at 200
