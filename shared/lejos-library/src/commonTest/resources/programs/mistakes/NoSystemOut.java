public class NoSystemOut {
    public static void main(String[] arguments) {
        System.out.println("Hello");
    }
}
// error 3
