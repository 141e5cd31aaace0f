import josx.platform.rcx.LCD;

public class ByteAndShort {
    public static void main(String[] arguments) {
        byte small = 127;
        small++;
        LCD.showNumber(-small); // shows: 128
        small = (byte) 0x1FF;
        LCD.showNumber(small + 2); // shows: 1
        LCD.showNumber(small & 0xFF); // shows: 255
        LCD.showNumber((byte) 300); // shows: 44
        short middle = (short) 65537;
        LCD.showNumber(middle); // shows: 1
        middle = (short) 40000;
        LCD.showNumber(middle < 0 ? 1 : 0); // shows: 1
        middle >>= 8;
        LCD.showNumber(-middle); // shows: 100
        small = 10;
        small *= 13;
        LCD.showNumber(small + 200); // shows: 74
    }
}
