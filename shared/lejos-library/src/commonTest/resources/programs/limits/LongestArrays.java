import josx.platform.rcx.LCD;

public class LongestArrays {
    public static void main(String[] arguments) {
        LCD.showNumber(new byte[511].length); // shows: 511
        LCD.showNumber(new byte[512].length); // forgiving shows: 512
    }
}
// brick fails 6 OutOfMemoryError
