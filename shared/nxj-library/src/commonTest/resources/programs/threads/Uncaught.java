/** A thread that fails does not keep the others from going on. */
class Uncaught { // only here
    public static void main(String[] args) throws Exception {
        Thread failing = new Thread() {
            public void run() {
                throw new IllegalStateException("no way"); // fails IllegalStateException
            }
        };
        failing.start();
        failing.join();
        System.out.println("goes on"); // expect goes on
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
        System.out.println("end"); // expect end
    }
}
