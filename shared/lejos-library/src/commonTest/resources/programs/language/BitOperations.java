import josx.platform.rcx.LCD;

public class BitOperations {
    public static void main(String[] arguments) {
        int a = 0xF0;
        int b = 0x3C;
        LCD.showNumber(a & b); // shows: 48
        LCD.showNumber(a | b); // shows: 252
        LCD.showNumber(a ^ b); // shows: 204
        LCD.showNumber(~a & 0xFF); // shows: 15
        LCD.showNumber(b << 3); // shows: 480
        LCD.showNumber(a >> 2); // shows: 60
        LCD.showNumber(-16 >> 2 & 0xFF); // shows: 252
        LCD.showNumber(-1 >>> 20); // shows: 4095
        LCD.showNumber(1 << 33); // shows: 2
        a <<= 1;
        a >>= 2;
        a >>>= 1;
        a ^= 1;
        a |= 2;
        a &= 0x3F;
        LCD.showNumber(a); // shows: 63
    }
}
