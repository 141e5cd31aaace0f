import josx.platform.rcx.LCD;

public class Stepped extends Thread {
    int count;

    public void run() {
        while (count < 20) {
            count++;
        }
    }

    static int twice(int number) {
        int result = number * 2;
        return result;
    }

    public static void main(String[] arguments) throws InterruptedException {
        Stepped other = new Stepped();
        other.start();
        int first = twice(3);
        Thread.sleep(100);
        int second = twice(first);
        LCD.showNumber(second);
    }
}
