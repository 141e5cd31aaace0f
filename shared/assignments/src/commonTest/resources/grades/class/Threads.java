public class Threads extends Thread {
    public static void main(String[] args) {
        while (true) {
            new Threads().start();
        }
    }

    public void run() {
        while (true) {
        }
    }
}
