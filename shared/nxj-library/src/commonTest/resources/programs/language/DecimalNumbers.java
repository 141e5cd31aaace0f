public class DecimalNumbers {
    static double field = 0.1;

    public static void main(String[] arguments) {
        double sum = 0;
        for (int i = 0; i < 10; i++) sum += field;
        System.out.println((sum == 1) + " " + (sum == 0.9999999999999999)); // expect false true
        System.out.println(field + 0.2 == 0.3); // expect false
        System.out.println(0.1f + 0.2f); // expect 0.3
        System.out.println(1.0 / 3 == 0.3333333333333333); // expect true
        System.out.println(1 / 3f == 0.33333334f); // expect true
        System.out.println(7.5 % 2); // expect 1.5
        System.out.println(-7.5 % 2); // expect -1.5
        System.out.println(5.5f % -2); // expect 1.5
        System.out.println(1.0 / 0); // expect Infinity
        System.out.println(-1.0 / 0); // expect -Infinity
        System.out.println(0.0 / 0); // expect NaN
        System.out.println(-0.0); // expect -0.0
        System.out.println(0.0 == -0.0); // expect true
        double none = 0.0 / 0;
        System.out.println(none == none); // expect false
        System.out.println(none < 1 || none > 1 || none == 1); // expect false
        System.out.println(!(none >= 1)); // expect true
        System.out.println((int) 3.99 + " " + (int) -3.99); // expect 3 -3
        System.out.println((int) 1e20 + " " + (int) -1e20 + " " + (int) none); // expect 2147483647 -2147483648 0
        System.out.println((long) 1e20 + " " + (long) -1e20 + " " + (long) none); // expect 9223372036854775807 -9223372036854775808 0
        System.out.println((byte) 300.7 + " " + (short) 70000.5 + " " + (int) (char) 65.9); // expect 44 4464 65
        System.out.println((float) 1e300 + " " + (float) 1e-300); // expect Infinity 0.0
        System.out.println(100.0); // expect 100.0
        System.out.println(12345678.0); // expect 1.2345678E7
        System.out.println(0.001); // expect 0.001
        System.out.println(0.0001); // expect 1.0E-4
        System.out.println(1e7f + " " + 9999999f); // expect 1.0E7 9999999.0
        double[] values = {1.5, 2.5};
        values[0] *= values[1]++;
        System.out.println(values[0] + " " + values[1]); // expect 3.75 3.5
        int whole = 7;
        whole *= 1.5;
        System.out.println(whole); // expect 10
        System.out.println(16777217 + " " + (float) 16777217 + " " + (double) 16777217); // expect 16777217 1.6777216E7 1.6777217E7
        System.out.println((double) Long.MAX_VALUE == 9.223372036854776E18); // expect true
    }
}
