public class Comparisons {
    static String compare(long a, long b) {
        return (a < b ? "<" : "") + (a <= b ? "l" : "") + (a == b ? "=" : "") + (a != b ? "!" : "") + (a >= b ? "g" : "") + (a > b ? ">" : "");
    }

    static String compare(double a, double b) {
        return (a < b ? "<" : "") + (a <= b ? "l" : "") + (a == b ? "=" : "") + (a != b ? "!" : "") + (a >= b ? "g" : "") + (a > b ? ">" : "");
    }

    static String compare(float a, float b) {
        return (a < b ? "<" : "") + (a <= b ? "l" : "") + (a == b ? "=" : "") + (a != b ? "!" : "") + (a >= b ? "g" : "") + (a > b ? ">" : "");
    }

    static String not(double a, double b) {
        return (!(a < b) ? "<" : "") + (!(a <= b) ? "l" : "") + (!(a >= b) ? "g" : "") + (!(a > b) ? ">" : "");
    }

    public static void main(String[] arguments) {
        System.out.println(compare(1L, 2L) + " " + compare(2L, 2L) + " " + compare(3L, 2L)); // expect <l! l=g !g>
        System.out.println(compare(1L << 32, 1L) + " " + compare(-1L, 1L << 33) + " " + compare(Long.MIN_VALUE, Long.MAX_VALUE)); // expect !g> <l! <l!
        System.out.println(compare(0xFFFFFFFFL, -1L)); // expect !g>
        System.out.println(compare(1.5, 2.5) + " " + compare(2.5, 2.5) + " " + compare(-0.0, 0.0)); // expect <l! l=g l=g
        System.out.println(compare(Double.NaN, 1.0) + " " + compare(1.0, Double.NaN) + " " + compare(Double.NaN, Double.NaN)); // expect ! ! !
        System.out.println(compare(Float.NaN, 1f) + " " + compare(1f, 2f) + " " + compare(Float.NEGATIVE_INFINITY, -1f)); // expect ! <l! <l!
        System.out.println(not(Double.NaN, 1) + " " + not(1, 2)); // expect <lg> g>
        Object one = "one";
        Object same = one;
        System.out.println((one == same) + " " + (one != null) + " " + (null == null)); // expect true true true
        boolean flag = 3 > 2;
        System.out.println(flag == true); // expect true
        System.out.println(flag != false ? 1 : 2); // expect 1
        int x = 5;
        System.out.println(0 < x && x < 10); // expect true
        System.out.println(!(x == 5) || x >= 6); // expect false
    }
}
