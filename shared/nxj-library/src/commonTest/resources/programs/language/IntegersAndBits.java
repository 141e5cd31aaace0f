public class IntegersAndBits {
    public static void main(String[] arguments) {
        System.out.println(Integer.MAX_VALUE + 1); // expect -2147483648
        System.out.println(Integer.MIN_VALUE / -1); // expect -2147483648
        System.out.println(Math.abs(Integer.MIN_VALUE)); // expect -2147483648
        System.out.println(100000 * 100000); // expect 1410065408
        System.out.println(1000000 / 70000 + " " + 1000000 % 70000); // expect 14 20000
        System.out.println(-17 / 5 + " " + -17 % 5 + " " + 17 / -5 + " " + 17 % -5); // expect -3 -2 -3 2
        System.out.println(1 << 33); // expect 2
        System.out.println(-1 >>> 28); // expect 15
        System.out.println(-256 >> 4); // expect -16
        System.out.println((byte) 200 + " " + (short) 70000 + " " + (int) (char) -1); // expect -56 4464 65535
        byte small = (byte) 0x80;
        System.out.println(small >> 1); // expect -64
        System.out.println(small >>> 1); // expect 2147483584
        System.out.println((small & 0xFF) >> 1); // expect 64
        small += 200;
        System.out.println(small); // expect 72
        short middle = 1000;
        middle *= 100;
        System.out.println(middle); // expect -31072
        char letter = 'z';
        letter++;
        System.out.println(letter); // expect {
        char wide = 60000;
        System.out.println((int) wide + " " + (wide > 50000)); // expect 60000 true
        int i = 5;
        i = i++ + ++i;
        System.out.println(i); // expect 12
        System.out.println(0x7F + 017 + 0xFFFFFFFF); // expect 141
        System.out.println((5 & 3) + " " + (5 | 3) + " " + (5 ^ 3) + " " + ~5); // expect 1 7 6 -6
        boolean yes = true;
        yes &= false | true;
        System.out.println(yes ^ true); // expect false
        System.out.println(i > 3 && i < 100 ? "between" : "outside"); // expect between
        int step = 0;
        if (step != 0 && 10 / step > 1) System.out.println("never");
        step += 1000;
        step -= 2000;
        System.out.println(step); // expect -1000
    }
}
