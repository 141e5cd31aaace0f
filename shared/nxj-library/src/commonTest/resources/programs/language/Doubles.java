/** Decimals of 64 and 32 bits. */
public class Doubles {
    static double kept = 0.1;
    double field = 2.5;

    public static void main(String[] args) {
        System.out.println((kept + 0.2 == 0.3) + " " + (kept + 0.2 == 0.30000000000000004)); // expect false true
        System.out.println(1e300 * 1e10); // expect Infinity
        System.out.println(0.0 / 0 == 0.0 / 0); // expect false
        System.out.println(1.0 / 3 == 0.3333333333333333); // expect true
        System.out.println(1.0f / 3 == 0.33333334f); // expect true
        System.out.println(7.5 % 2 + " " + -7.5f % 2); // expect 1.5 -1.5
        System.out.println(1e17 % 3 + " " + 5e-324 % 3); // expect 1.0 4.9E-324
        System.out.println((int) 1e20 + " " + (long) 1e20 + " " + (int) Double.NaN); // expect 2147483647 9223372036854775807 0
        System.out.println((float) 0.1 + " " + (double) 0.1f); // expect 0.1 0.10000000149011612
        System.out.println((long) -2.9 + " " + (long) 3.9f + " " + (char) 66.7); // expect -2 3 B
        Doubles doubles = new Doubles();
        doubles.field /= -4;
        System.out.println(doubles.field); // expect -0.625
        double[] many = {1.5, 2.5};
        many[0] += many[1];
        System.out.println(many[0] + many.length); // expect 6.0
        System.out.println(Math.round(Math.sqrt(2) * 1e9)); // expect 1414213562
        System.out.println(Math.round(2.5) + " " + Math.round(-2.5f)); // expect 3 -2
        System.out.println(less(1, 2) + " " + less(2, 1) + " " + less(1, Double.NaN)); // expect true false false
        System.out.println(Math.floor(-1.5) + " " + Math.ceil(-1.5) + " " + Math.abs(-0.0)); // expect -2.0 -1.0 0.0
        System.out.println(Double.doubleToLongBits(1.0) + " " + Float.floatToIntBits(1f)); // expect 4607182418800017408 1065353216
        System.out.println(Double.longBitsToDouble(4611686018427387904L)); // expect 2.0
        System.out.println(Math.pow(2, 10) + " " + Math.round(Math.sin(Math.PI / 6) * 1e9)); // expect 1024.0 500000000
        long sum = 0;
        for (double x = 0; x < 1; x += 0.125) sum += (long) (x * 1000);
        System.out.println(sum); // expect 3500
    }

    static boolean less(double a, double b) {
        return a < b;
    }
}
