public class BitOperations {
    public static void main(String[] arguments) {
        int a = 0xF0;
        int b = 0x3C;
        System.out.println(a & b); // expect 48
        System.out.println(a | b); // expect 252
        System.out.println(a ^ b); // expect 204
        System.out.println(~a & 0xFF); // expect 15
        System.out.println(b << 3); // expect 480
        System.out.println(a >> 2); // expect 60
        System.out.println(-16 >> 2 & 0xFF); // expect 252
        System.out.println(-1 >>> 20); // expect 4095
        System.out.println(1 << 33); // expect 2
        a <<= 1;
        a >>= 2;
        a >>>= 1;
        a ^= 1;
        a |= 2;
        a &= 0x3F;
        System.out.println(a); // expect 63
    }
}
