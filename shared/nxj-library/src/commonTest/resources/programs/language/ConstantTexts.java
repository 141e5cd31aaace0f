// Constants in texts are written by the compiler, with the digits that Java had when leJOS NXJ was made.
// only here
public class ConstantTexts {
    static final double LARGE = 1e23;

    public static void main(String[] arguments) {
        System.out.println("" + (float) 16777217 + " " + (double) 16777217); // expect 1.6777216E7 1.6777217E7
        System.out.println("" + (float) 123456789L + " " + 3.4e10f); // expect 1.23456792E8 3.3999999E10
        System.out.println("" + LARGE + " " + 9007199254740993e3); // expect 9.999999999999999E22 9.007199254740993E18
        System.out.println("" + 1 / 3.0 + " " + 1 / 3f + " " + 0.1f); // expect 0.3333333333333333 0.33333334 0.1
        System.out.println("" + 100.0 + " " + 1e7 + " " + 0.001 + " " + 0.0001); // expect 100.0 1.0E7 0.001 1.0E-4
        System.out.println("" + 4.9e-324 + " " + 1.1e-44f + " " + -2.5); // expect 4.9E-324 1.1E-44 -2.5
        System.out.println("" + 0.0 + " " + -0.0f + " " + 1 / 0.0); // expect 0.0 -0.0 Infinity
    }
}
