/** What leJOS NXJ's mathematics does otherwise than Java's. */
public class MathematicsOfTheBrick { // only here
    public static void main(String[] arguments) {
        System.out.println(Math.sin(Math.PI) + " " + Math.cos(Math.PI / 2) + " " + Math.sin(-Math.PI)); // expect 0.0 0.0 -0.0
        System.out.println(Math.tan(Math.PI / 2) + " " + Math.tan(Math.PI)); // expect Infinity 0.0
        System.out.println(Math.sin(Double.POSITIVE_INFINITY) + " " + Math.cos(Double.NaN)); // expect NaN NaN
        System.out.println(Math.rint(2.5) + " " + Math.rint(-2.5) + " " + Math.rint(-0.25)); // expect 3.0 -3.0 0.0
        System.out.println(Math.rint(Double.NaN) + " " + Math.rint(1e19) + " " + Math.rint(-0.5)); // expect 0.0 1.0E19 -1.0
        System.out.println(Math.round(0.49999999999999994) + " " + Math.round(-2.5) + " " + Math.round(1e300)); // expect 1 -2 9223372036854775807
        System.out.println(Math.round(0.49999997f) + " " + Math.round(3e9f) + " " + Math.round(Float.NaN)); // expect 0 2147483647 0
        System.out.println(Math.atan2(-0.0, -1) == Math.PI); // expect true
        System.out.println(Math.atan2(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY) == Math.PI - Math.PI / 4); // expect true
        System.out.println(Math.atan2(0, 0) + " " + Math.atan2(0, Double.NaN)); // expect 0.0 NaN
        // Powers are rounded on the way, so the whole number below can be cut out of them.
        System.out.println(Math.pow(2, 3) + " " + (int) Math.pow(2, 3) + " " + Math.round(Math.pow(2, 3))); // expect 8.0 7 8
        System.out.println((int) Math.pow(10, 3) + " " + (int) Math.pow(2, 10) + " " + (int) Math.pow(3, 2)); // expect 999 1024 9
        System.out.println(Math.pow(-2, 3) + " " + Math.pow(-2, 0.5) + " " + Math.pow(-0.0, -3)); // expect -8.0 NaN -Infinity
        System.out.println(Math.exp(710.5) + " " + Math.exp(-750.5) + " " + Math.exp(-1e10)); // expect Infinity 0.0 0.0
        System.out.println(Math.log(-1) + " " + Math.log(1) + " " + Math.log(Double.MIN_VALUE)); // expect NaN 0.0 -744.440071921381
        System.out.println(Math.sqrt(Double.MIN_VALUE) + " " + (Math.sqrt(1e-310) > 0) + " " + Math.sqrt(-0.0)); // expect 2.22275874948508E-162 true -0.0
        System.out.println(Math.toDegrees(Math.PI) + " " + (Math.toRadians(180) == Math.PI)); // expect 180.0 true
        int wrong = 0;
        for (int side = 1; side <= 1000; side++) {
            if ((int) Math.sqrt(side * side) != side) wrong++;
        }
        System.out.println(wrong); // expect 0
    }
}
