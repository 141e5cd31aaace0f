/** Decimal numbers as leJOS NXJ writes them: with at most 15 digits of a double and 7 of a float. */
public class DecimalTexts { // only here
    public static void main(String[] arguments) {
        double[] values = {1e-4, 0.00123, 0.5, 3, 99.99, 7654321.0, 87654321.5, 1e18, 2.5e300, 7e-320, 5e-5, 640};
        for (double value : values) System.out.println(value + " " + -value); // expect 1.0E-4 -1.0E-4
        // expect 0.00123 -0.00123
        // expect 0.5 -0.5
        // expect 3.0 -3.0
        // expect 99.99 -99.99
        // expect 7654321.0 -7654321.0
        // expect 8.76543215E7 -8.76543215E7
        // expect 1.0E18 -1.0E18
        // expect 2.5E300 -2.5E300
        // expect 6.99992207027878E-320 -6.99992207027878E-320
        // expect 5.0E-5 -5.0E-5
        // expect 640.0 -640.0
        float[] floats = {2e-4f, 0.7f, 2.5e38f, 7e-40f, 8388609f, 3.3333333f, 123456f, 1e6f, 7654321f, 54321.987f, 0.0625f};
        for (float value : floats) System.out.println(value); // expect 2.0E-4
        // expect 0.7
        // expect 2.5E38
        // expect 7.000005E-40
        // expect 8.38861E6
        // expect 3.333333
        // expect 123456.0
        // expect 1.0E6
        // expect 7.654321E6
        // expect 54321.99
        // expect 0.0625
        double third = 1 / 3.0;
        float half = 0.5f;
        System.out.println(third + " " + 2 * third + " " + 10 * third); // expect 0.333333333333333 0.666666666666667 3.33333333333333
        System.out.println(half / 1.5f + " " + half / 1.5f * 2); // expect 0.3333334 0.6666667
        System.out.println(third + 0.1 + " " + (third * 0.3 + 0.2)); // expect 0.433333333333333 0.3
        System.out.println(3 * third * 0.1 + 0.2); // expect 0.3
        System.out.println((0.1 + 0.7) * 10); // expect 8.0
        System.out.println(3 * third * Math.PI * 3e5 + " " + Math.E * third * 1e-5); // expect 942477.796076938 9.06093942819682E-6
        System.out.println(third - third + " " + -(third - third)); // expect 0.0 -0.0
        System.out.println(third / 0 + " " + -third / 0 + " " + 0 / (third - third)); // expect Infinity -Infinity NaN
        System.out.println(new StringBuffer().append(third).append(half / 1.5f)); // expect 0.3333333333333330.3333334
        System.out.println(new StringBuilder().append(third).append(' ').append(half / 1.5f)); // expect 0.333333333333333 0.3333334
        System.out.println(String.valueOf(third) + Double.valueOf(third) + Double.toString(third)); // expect 0.3333333333333330.3333333333333330.333333333333333
        System.out.println(String.valueOf(half / 1.5f) + new Float(half / 1.5f) + Float.toString(half / 1.5f)); // expect 0.33333340.33333340.3333334
        // The compiler writes constants, with all digits.
        System.out.println("" + (0.1 + 0.2) + " " + 1 / 3f); // expect 0.30000000000000004 0.33333334
    }
}
