public class DeepAndWide {
    static int ackermann(int m, int n) {
        return m == 0 ? n + 1 : n == 0 ? ackermann(m - 1, 1) : ackermann(m - 1, ackermann(m, n - 1));
    }

    static boolean isEven(int n) {
        return n == 0 || isOdd(n - 1);
    }

    static boolean isOdd(int n) {
        return n != 0 && isEven(n - 1);
    }

    static long many(int a, long b, byte c, double d, short e, float f, char g, boolean h, int i, long j) {
        return a + b + c + (long) d + e + (long) f + g + (h ? 1 : 0) + i + j;
    }

    static int depth(int[][][][] array) {
        return array.length * array[0].length * array[0][0].length * array[0][0][0].length;
    }

    static String permutations(String prefix, String rest) {
        if (rest.length() == 0) return prefix + " ";
        String all = "";
        for (int i = 0; i < rest.length(); i++) {
            all += permutations(prefix + rest.charAt(i), rest.substring(0, i) + rest.substring(i + 1));
        }
        return all;
    }

    public static void main(String[] arguments) {
        System.out.println(ackermann(2, 5)); // expect 13
        System.out.println(isEven(60) + " " + isOdd(61)); // expect true true
        System.out.println(many(1, 2, (byte) 3, 4.9, (short) 5, 6.9f, 'a', true, 8, 9)); // expect 136
        System.out.println(depth(new int[2][3][4][5])); // expect 120
        System.out.println(permutations("", "abc").trim()); // expect abc acb bac bca cab cba
        int result = 1;
        result = result++ + ++result * (result = 5) - result--;
        System.out.println(result); // expect 11
        System.out.println(((((1 + 2) * 3 - 4) << 2 ^ 7) & 0x1F) + (5 > 3 == true ? 10 : 20)); // expect 29
    }
}
