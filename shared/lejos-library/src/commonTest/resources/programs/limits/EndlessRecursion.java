public class EndlessRecursion {
    static int deeper(int depth) {
        return deeper(depth + 1) + 1;
    }

    public static void main(String[] arguments) {
        deeper(0);
    }
}
// fails 3 StackOverflowError
