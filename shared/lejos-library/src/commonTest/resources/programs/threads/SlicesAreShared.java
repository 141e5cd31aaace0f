import josx.platform.rcx.LCD;

public class SlicesAreShared extends Thread {
    private int turns = 0;

    public void run() {
        while (true) turns++;
    }

    public static void main(String[] arguments) throws InterruptedException {
        SlicesAreShared first = new SlicesAreShared();
        SlicesAreShared second = new SlicesAreShared();
        first.setDaemon(true);
        second.setDaemon(true);
        first.start();
        second.start();
        Thread.sleep(1000);
        LCD.showNumber(first.turns > second.turns / 2 && second.turns > first.turns / 2 ? 1 : 0); // shows: 1
    }
}
