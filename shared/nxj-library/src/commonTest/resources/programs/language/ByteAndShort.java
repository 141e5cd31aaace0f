public class ByteAndShort {
    public static void main(String[] arguments) {
        byte small = 127;
        small++;
        System.out.println(-small); // prints: 128
        small = (byte) 0x1FF;
        System.out.println(small + 2); // prints: 1
        System.out.println(small & 0xFF); // prints: 255
        System.out.println((byte) 300); // prints: 44
        short middle = (short) 65537;
        System.out.println(middle); // prints: 1
        middle = (short) 40000;
        System.out.println(middle < 0 ? 1 : 0); // prints: 1
        middle >>= 8;
        System.out.println(-middle); // prints: 100
        small = 10;
        small *= 13;
        System.out.println(small + 200); // prints: 74
    }
}
