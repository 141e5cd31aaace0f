import josx.platform.rcx.LCD;

public class FloatBits {
    public static void main(String[] arguments) {
        LCD.showNumber(Float.floatToIntBits(1f) == 0x3F800000 ? 1 : 0); // shows: 1
        LCD.showNumber(Float.floatToIntBits(-2f) == 0xC0000000 ? 1 : 0); // shows: 1
        LCD.showNumber((int) Float.intBitsToFloat(0x41200000)); // shows: 10
        LCD.showNumber(Float.floatToIntBits((float) Math.sqrt(-1)) == 0x7FC00000 ? 1 : 0); // shows: 1
    }
}
