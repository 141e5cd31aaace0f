// only here
/** A handler deals with an exception that nobody catches; without one, all threads stand still and the program ends. */
public class Uncaught {
    public static void main(String[] args) throws Exception {
        Thread told = new Thread() {
            public void run() {
                String text = null;
                text.length();
            }
        };
        told.setUncaughtExceptionHandler(new Thread.UncaughtExceptionHandler() {
            public void uncaughtException(Thread thread, Throwable thrown) {
                System.out.println(thrown instanceof NullPointerException); // expect true
            }
        });
        told.start();
        told.join();
        System.out.println("goes on"); // expect goes on
        Thread failing = new Thread() {
            public void run() {
                throw new IllegalStateException("no way"); // fails IllegalStateException
            }
        };
        failing.start();
        failing.join();
        System.out.println("never");
    }
}
