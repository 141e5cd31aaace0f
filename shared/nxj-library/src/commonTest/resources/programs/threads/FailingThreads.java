public class FailingThreads {
    public static void main(String[] arguments) throws InterruptedException {
        Thread failing = new Thread("failing") {
            @Override
            public void run() {
                System.out.println(getName()); // expect failing
                int[] none = new int[0];
                none[0] = 1;
            }
        };
        failing.setUncaughtExceptionHandler(new Thread.UncaughtExceptionHandler() {
            public void uncaughtException(Thread thread, Throwable thrown) {
                System.out.println(thread.getName() + " " + (thrown instanceof ArrayIndexOutOfBoundsException)); // expect failing true
            }
        });
        failing.start();
        failing.join();
        System.out.println("main goes on"); // expect main goes on
        try {
            synchronized (failing) {
                throw new IllegalStateException("locked");
            }
        } catch (IllegalStateException wrong) {
            System.out.println(wrong.getMessage()); // expect locked
        }
        synchronized (failing) {
            System.out.println("free again"); // expect free again
        }
    }
}
