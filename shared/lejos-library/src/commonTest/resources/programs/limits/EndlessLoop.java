public class EndlessLoop {
    public static void main(String[] arguments) {
        while (true) {
        }
    }
}
// runs on after 2000
