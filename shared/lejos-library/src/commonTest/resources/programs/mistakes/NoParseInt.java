public class NoParseInt {
    public static void main(String[] arguments) {
        int number = Integer.parseInt("7");
        String part = "abc".substring(1);
        int place = "abc".indexOf("b");
    }
}
// error 3
// error 4
// error 5
