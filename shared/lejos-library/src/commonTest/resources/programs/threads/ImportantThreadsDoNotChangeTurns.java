import josx.platform.rcx.LCD;

/** A thread of a higher priority that wakes now and then does not change whose turn it is among the others. */
public class ImportantThreadsDoNotChangeTurns extends Thread {
    private int turns = 0;

    public void run() {
        while (true) turns++;
    }

    static class Important extends Thread {
        public void run() {
            try {
                while (true) sleep(3);
            } catch (InterruptedException end) {
                return;
            }
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        ImportantThreadsDoNotChangeTurns first = new ImportantThreadsDoNotChangeTurns();
        ImportantThreadsDoNotChangeTurns second = new ImportantThreadsDoNotChangeTurns();
        Thread important = new Important();
        important.setPriority(Thread.MAX_PRIORITY);
        Thread[] daemons = {first, second, important};
        for (int index = 0; index < daemons.length; index++) {
            daemons[index].setDaemon(true);
            daemons[index].start();
        }
        Thread.sleep(1000);
        LCD.showNumber(first.turns > second.turns / 2 && second.turns > first.turns / 2 ? 1 : 0); // shows: 1
    }
}
