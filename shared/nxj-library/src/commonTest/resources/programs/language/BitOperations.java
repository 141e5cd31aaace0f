public class BitOperations {
    public static void main(String[] arguments) {
        int a = 0xF0;
        int b = 0x3C;
        System.out.println(a & b); // prints: 48
        System.out.println(a | b); // prints: 252
        System.out.println(a ^ b); // prints: 204
        System.out.println(~a & 0xFF); // prints: 15
        System.out.println(b << 3); // prints: 480
        System.out.println(a >> 2); // prints: 60
        System.out.println(-16 >> 2 & 0xFF); // prints: 252
        System.out.println(-1 >>> 20); // prints: 4095
        System.out.println(1 << 33); // prints: 2
        a <<= 1;
        a >>= 2;
        a >>>= 1;
        a ^= 1;
        a |= 2;
        a &= 0x3F;
        System.out.println(a); // prints: 63
    }
}
