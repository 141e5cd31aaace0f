import josx.platform.rcx.LCD;

public class ArraysOfAllKinds {
    public static void main(String[] arguments) {
        byte[] bytes = {-1, 2};
        LCD.showNumber(bytes[0] + bytes[1]); // shows: 1
        short[] shorts = {-300, 400};
        LCD.showNumber(shorts[0] + shorts[1]); // shows: 100
        char[] letters = {'a', 'b'};
        LCD.showNumber(letters[1] - letters[0]); // shows: 1
        float[] decimals = {0.5f, 1.5f};
        LCD.showNumber((int) (decimals[0] + decimals[1])); // shows: 2
        double[] wide = {0.25, 3.75};
        LCD.showNumber((int) (wide[0] + wide[1])); // shows: 4
        Object[] things = {"text", new int[3], letters};
        LCD.showNumber(things.length); // shows: 3
    }
}
