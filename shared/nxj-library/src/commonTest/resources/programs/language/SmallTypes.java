public class SmallTypes {
    byte b = -1;
    short s = -2;
    char c = 'c';
    boolean z = true;
    byte b2 = 5;
    static byte sb = 100;
    static short ss = 30000;
    static char sc = 65535;
    static boolean sz;

    static byte bytes(byte value) {
        return ++value;
    }

    static char chars(char value) {
        return value--;
    }

    static short shorts(int value) {
        return (short) value;
    }

    public static void main(String[] arguments) {
        SmallTypes types = new SmallTypes();
        types.b += 130;
        types.s *= 20000;
        types.c += 1;
        types.z = !types.z;
        System.out.println(types.b + " " + types.s + " " + types.c + " " + types.z + " " + types.b2); // expect -127 25536 d false 5
        sb += 100;
        ss += 5000;
        sc++;
        sz |= true;
        System.out.println(sb + " " + ss + " " + (int) sc + " " + sz); // expect -56 -30536 0 true
        System.out.println(bytes((byte) 127) + " " + chars('x') + " " + shorts(70000)); // expect -128 x 4464
        types.b2 >>= 1;
        types.b <<= 3;
        System.out.println(types.b2 + " " + types.b); // expect 2 8
        char[] letters = new char[2];
        letters[0] = (char) -1;
        letters[1]--;
        System.out.println((int) letters[0] + " " + (int) letters[1]); // expect 65535 65535
        byte[] bytes = {1, 2, 3};
        bytes[1] *= 100;
        bytes[2] ^= 0x7F;
        System.out.println(bytes[1] + " " + bytes[2]); // expect -56 124
        short[] shorts = new short[1];
        shorts[0]--;
        shorts[0] >>>= 1;
        System.out.println(shorts[0]); // expect -1
        boolean[] flags = {true, false};
        flags[0] &= flags[1];
        System.out.println(flags[0] | flags[1]); // expect false
    }
}
