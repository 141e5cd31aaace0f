public class UnhandledException {
    public static void main(String[] arguments) {
        Thread.sleep(100);
    }
}
// error 3
