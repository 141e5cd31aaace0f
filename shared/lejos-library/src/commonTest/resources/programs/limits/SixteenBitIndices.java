import josx.platform.rcx.LCD;

public class SixteenBitIndices {
    public static void main(String[] arguments) {
        int[] numbers = {5, 6};
        int index = 65537;
        LCD.showNumber(numbers[index]); // brick shows: 6
    }
}
// forgiving fails 7 ArrayIndexOutOfBoundsException
