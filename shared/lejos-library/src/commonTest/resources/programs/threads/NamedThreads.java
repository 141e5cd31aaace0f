import josx.platform.rcx.LCD;

public class NamedThreads extends Thread {
    NamedThreads(String name) {
        super(name);
    }

    public void run() {
        LCD.showNumber(currentThread() == this ? 1 : 0); // shows: 0 1
    }

    public static void main(String[] arguments) {
        NamedThreads thread = new NamedThreads("other");
        thread.run();
        thread.start();
    }
}
