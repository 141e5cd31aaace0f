import josx.platform.rcx.LCD;

public class ThreadsInheritPriority extends Thread {
    public void run() {
    }

    public static void main(String[] arguments) {
        Thread.currentThread().setPriority(8);
        LCD.showNumber(new ThreadsInheritPriority().getPriority()); // shows: 8
        Thread.currentThread().setPriority(2);
        LCD.showNumber(new ThreadsInheritPriority().getPriority()); // shows: 2
    }
}
