public class ByteAndShort {
    public static void main(String[] arguments) {
        byte small = 127;
        small++;
        System.out.println(-small); // expect 128
        small = (byte) 0x1FF;
        System.out.println(small + 2); // expect 1
        System.out.println(small & 0xFF); // expect 255
        System.out.println((byte) 300); // expect 44
        short middle = (short) 65537;
        System.out.println(middle); // expect 1
        middle = (short) 40000;
        System.out.println(middle < 0 ? 1 : 0); // expect 1
        middle >>= 8;
        System.out.println(-middle); // expect 100
        small = 10;
        small *= 13;
        System.out.println(small + 200); // expect 74
    }
}
