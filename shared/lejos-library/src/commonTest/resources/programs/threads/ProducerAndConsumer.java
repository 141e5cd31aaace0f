import java.util.Queue;
import josx.platform.rcx.LCD;

public class ProducerAndConsumer {
    static final Queue letters = new Queue();

    static class Writer extends Thread {
        public void run() {
            for (int number = 1; number <= 3; number++) {
                synchronized (letters) {
                    letters.push(new Letter(number));
                    letters.notify();
                }
                Thread.yield();
            }
        }
    }

    static class Letter {
        final int number;

        Letter(int number) {
            this.number = number;
        }
    }

    public static void main(String[] arguments) throws InterruptedException {
        new Writer().start();
        for (int read = 0; read < 3; read++) {
            synchronized (letters) {
                while (letters.empty()) letters.wait();
                LCD.showNumber(((Letter) letters.pop()).number); // shows: 1 2 3
            }
        }
    }
}
