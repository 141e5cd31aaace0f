import josx.platform.rcx.LCD;

/** If there is no array for a larger stack, a brick throws two errors, and the second one inside the catch of the first. */
public class StackForManyVariables {
    static int depth = 0;

    static void deeper(int a, int b, int c, int d, int e, int f, int g, int h) {
        depth++;
        deeper(a, b, c, d, e, f, g, h);
    }

    public static void main(String[] arguments) {
        try {
            try {
                deeper(1, 2, 3, 4, 5, 6, 7, 8);
            } catch (OutOfMemoryError first) {
                LCD.showNumber(1);
            } catch (StackOverflowError only) {
                LCD.showNumber(2); // forgiving shows: 2
            }
        } catch (StackOverflowError second) {
            LCD.showNumber(3); // brick shows: 3
        }
        LCD.showNumber(depth); // brick shows: 60 // forgiving shows: 254
    }
}
