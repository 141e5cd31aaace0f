public class NoEnum {
    enum Colour { RED, BLUE }

    public static void main(String[] arguments) {
    }
}
// error 2
