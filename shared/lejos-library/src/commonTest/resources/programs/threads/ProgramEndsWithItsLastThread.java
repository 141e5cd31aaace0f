public class ProgramEndsWithItsLastThread extends Thread {
    public void run() {
        try {
            Thread.sleep(400);
        } catch (InterruptedException never) {
            return;
        }
    }

    public static void main(String[] arguments) {
        new ProgramEndsWithItsLastThread().start();
    }
}
// ends at 400
