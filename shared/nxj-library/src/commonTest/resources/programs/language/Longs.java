/** Whole numbers of 64 bits. */
public class Longs {
    static long kept = 5000000000L;
    long field = -3;

    public static void main(String[] args) {
        long big = 1234567890123L;
        System.out.println(big); // expect 1234567890123
        System.out.println(big * 1000); // expect 1234567890123000
        System.out.println(big / 7 + " " + big % 7); // expect 176366841446 1
        System.out.println(Long.MIN_VALUE / -1); // expect -9223372036854775808
        System.out.println(Long.MIN_VALUE % -1); // expect 0
        System.out.println(-big >> 3); // expect -154320986266
        System.out.println(-big >>> 60); // expect 15
        System.out.println(1L << 40 | 5); // expect 1099511627781
        System.out.println(kept++ + ++kept); // expect 10000000002
        Longs longs = new Longs();
        longs.field *= 4000000000L;
        System.out.println(longs.field); // expect -12000000000
        long[] many = {1, 2, kept};
        many[1] -= many[2];
        System.out.println(many[1]); // expect -5000000000
        System.out.println((int) big + " " + (short) big + " " + (byte) big); // expect 1912276171 1227 -53
        System.out.println(compare(3, 4) + " " + compare(5000000000L, 4) + " " + compare(7, 7)); // expect -1 1 0
        System.out.println(sum(1, 2L, 3, 4L)); // expect 10
        System.out.println(~big ^ 0xFFL & 255); // expect -1234567889973
        try {
            System.out.println(big / (kept - kept));
        } catch (ArithmeticException e) {
            System.out.println("by zero"); // expect by zero
        }
        System.out.println(Long.parseLong("-9000000000") + Long.toString(255, 16)); // expect -9000000000ff
    }

    static int compare(long a, long b) {
        return a < b ? -1 : a > b ? 1 : 0;
    }

    static long sum(int a, long b, int c, long d) {
        return a + b + c + d;
    }
}
