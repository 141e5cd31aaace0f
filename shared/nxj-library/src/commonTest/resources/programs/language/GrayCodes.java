public class GrayCodes {
    static int gray(int number) {
        return number ^ number >>> 1;
    }

    static int number(int gray) {
        int number = 0;
        for (int bits = gray; bits != 0; bits >>>= 1) number ^= bits;
        return number;
    }

    static int bits(long value) {
        int count = 0;
        for (; value != 0; value &= value - 1) count++;
        return count;
    }

    static short swapped(short value) {
        return (short) (value << 8 | value >> 8 & 0xFF);
    }

    static byte parity(byte[] message) {
        byte parity = 0x55;
        for (byte one : message) parity ^= one;
        return parity;
    }

    static int check(byte[] message) {
        int crc = 0xFFFF;
        for (byte one : message) {
            crc ^= (one & 0xFF) << 8;
            for (int bit = 0; bit < 8; bit++) crc = (crc & 0x8000) != 0 ? crc << 1 ^ 0x1021 : crc << 1;
            crc &= 0xFFFF;
        }
        return crc;
    }

    public static void main(String[] arguments) {
        StringBuilder codes = new StringBuilder();
        boolean isSame = true;
        for (int i = 0; i < 64; i++) {
            if (i < 8) codes.append(gray(i)).append(' ');
            if (number(gray(i)) != i || i > 0 && bits(gray(i) ^ gray(i - 1)) != 1) isSame = false;
        }
        System.out.println(codes + "" + isSame);
        System.out.println(bits(-1) + " " + bits(0x8000000000000001L) + " " + bits(Integer.MIN_VALUE));
        System.out.println(swapped((short) 0x1234) + " " + swapped((short) 0x80FF));
        byte[] message = {49, 50, 51, 52, 53, 54, 55, 56, 57};
        System.out.println(check(message) + " " + parity(message));
        System.out.println((-17 >> 2) + " " + (-17 >>> 28) + " " + (1 << 33) + " " + (1L << 33) + " " + (byte) 200 + " " + (char) 98);
        // expect 0 1 3 2 6 7 5 4 true
        // expect 64 2 33
        // expect 13330 -128
        // expect 10673 100
        // expect -5 15 2 8589934592 -56 b
    }
}
