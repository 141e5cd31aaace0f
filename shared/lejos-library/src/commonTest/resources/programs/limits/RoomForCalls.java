import josx.platform.rcx.LCD;

public class RoomForCalls {
    static int depth = 0;

    static void deeper() {
        depth++;
        deeper();
    }

    static void wider(int a, int b, int c, int d, int e, int f, int g, int h) {
        depth++;
        wider(a, b, c, d, e, f, g, h);
    }

    static void showDepth(boolean isWide) {
        depth = 0;
        try {
            if (isWide) wider(1, 2, 3, 4, 5, 6, 7, 8);
            deeper();
        } catch (StackOverflowError tooDeep) {
            LCD.showNumber(depth); // brick shows: 209 // forgiving shows: 253 253
        }
    }

    public static void main(String[] arguments) {
        showDepth(false);
        try {
            try {
                showDepth(true);
            } catch (OutOfMemoryError noArrayForTheStack) {
                LCD.showNumber(1);
            }
        } catch (StackOverflowError second) {
            LCD.showNumber(depth); // brick shows: 60
        }
    }
}
