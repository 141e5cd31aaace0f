public class DecimalTexts {
    public static void main(String[] arguments) {
        double[] values = {1e-4, 0.00123, 0.5, 3, 99.99, 1234567.0, 12345678.9, 1e21, 1.7976931348623157e308, 4.9e-324, 5e-5, 100};
        for (double value : values) System.out.println(value + " " + -value); // expect 1.0E-4 -1.0E-4
        // expect 0.00123 -0.00123
        // expect 0.5 -0.5
        // expect 3.0 -3.0
        // expect 99.99 -99.99
        // expect 1234567.0 -1234567.0
        // expect 1.23456789E7 -1.23456789E7
        // expect 1.0E21 -1.0E21
        // expect 1.7976931348623157E308 -1.7976931348623157E308
        // expect 4.9E-324 -4.9E-324
        // expect 5.0E-5 -5.0E-5
        // expect 100.0 -100.0
        float[] floats = {1e-4f, 0.1f, 3.4028235e38f, 1.4e-45f, 16777216f, 3.3333333f, 1e7f, 12345.678f};
        for (float value : floats) System.out.println(value); // expect 1.0E-4
        // expect 0.1
        // expect 3.4028235E38
        // expect 1.4E-45
        // expect 1.6777216E7
        // expect 3.3333333
        // expect 1.0E7
        // expect 12345.678
        double third = 1 / 3.0;
        double sum = third + third + third;
        System.out.println(third + " " + sum + " " + (sum == 1)); // expect 0.3333333333333333 1.0 true
        for (int i = 1; i <= 10; i++) System.out.println(i / 10.0); // expect 0.1
        // expect 0.2
        // expect 0.3
        // expect 0.4
        // expect 0.5
        // expect 0.6
        // expect 0.7
        // expect 0.8
        // expect 0.9
        // expect 1.0
        System.out.println(1e16 + 1); // expect 1.0E16
        System.out.println((0.1 + 0.7) * 10); // expect 7.999999999999999
        System.out.println(Math.PI * 1e5 + " " + Math.E * 1e-5); // expect 314159.2653589793 2.7182818284590452E-5
    }
}
