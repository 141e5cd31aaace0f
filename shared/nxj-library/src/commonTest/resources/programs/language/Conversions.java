public class Conversions {
    public static void main(String[] arguments) {
        int i = 0x12345678;
        long l = 0x123456789ABCDEF0L;
        float f = 1234.567f;
        double d = -98765.4321;
        System.out.println((long) i + " " + (int) (float) i + " " + (double) i); // expect 305419896 305419904 3.05419896E8
        System.out.println((int) l + " " + (long) (float) l + " " + (long) (double) l); // expect -1698898192 1311768499227459584 1311768467463790336
        System.out.println((int) f + " " + (long) f + " " + (long) ((double) f * 1e6)); // expect 1234 1234 1234567016
        System.out.println((int) d + " " + (long) d + " " + (int) ((float) d * 100)); // expect -98765 -98765 -9876543
        System.out.println((byte) i + " " + (short) i + " " + (int) (char) i); // expect 120 22136 22136
        System.out.println((byte) l + " " + (short) l + " " + (int) (char) l); // expect -16 -8464 57072
        System.out.println((byte) f + " " + (short) f + " " + (int) (char) f); // expect -46 1234 1234
        System.out.println((byte) d + " " + (short) d + " " + (int) (char) d); // expect 51 32307 32307
        System.out.println((int) Float.NaN + " " + (long) Double.NaN); // expect 0 0
        System.out.println((int) Float.POSITIVE_INFINITY + " " + (long) Double.NEGATIVE_INFINITY); // expect 2147483647 -9223372036854775808
        System.out.println((float) 16777217 + " " + (float) 1e40 + " " + (float) 0.1); // expect 1.6777216E7 Infinity 0.1
        System.out.println((long) ((double) 0.1f * 1e12)); // expect 100000001490
        System.out.println((long) 9.3e18 + " " + (int) 2147483647.9); // expect 9223372036854775807 2147483647
        byte b = -1;
        System.out.println((char) b == 0xFFFF); // expect true
        System.out.println((b & 0xFF) + " " + (b >>> 4) + " " + ((b & 0xFF) >>> 4)); // expect 255 268435455 15
        short s = (short) 0x8000;
        System.out.println(s + " " + (s >> 15) + " " + -s); // expect -32768 -1 32768
        System.out.println('a' + 1 + " " + (char) ('a' + 1) + " " + (int) 'a'); // expect 98 b 97
        final int small = 100;
        byte fits = small;
        System.out.println(fits); // expect 100
        System.out.println(5 / 2 + " " + 5 / 2.0 + " " + 5 / 2f + " " + 5L / 2); // expect 2 2.5 2.5 2
        System.out.println((1.0f * Integer.MAX_VALUE == 2147483648f) + " " + 1.0 * Integer.MAX_VALUE); // expect true 2.147483647E9
    }
}
