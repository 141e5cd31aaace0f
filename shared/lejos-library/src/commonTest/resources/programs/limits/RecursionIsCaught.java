import josx.platform.rcx.LCD;

public class RecursionIsCaught {
    static int depth = 0;

    static void deeper() {
        depth++;
        deeper();
    }

    public static void main(String[] arguments) {
        try {
            deeper();
        } catch (StackOverflowError tooDeep) {
            LCD.showNumber(depth > 5 ? 1 : 0); // shows: 1
        }
    }
}
