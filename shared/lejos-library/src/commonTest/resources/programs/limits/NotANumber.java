import josx.platform.rcx.LCD;

public class NotANumber {
    public static void main(String[] arguments) {
        float nothing = Float.intBitsToFloat(0x7FC00000);
        LCD.showNumber(nothing == 1f ? 1 : 0); // brick shows: 1 // forgiving shows: 0
        LCD.showNumber(nothing < 1f ? 1 : 0); // shows: 0
    }
}
