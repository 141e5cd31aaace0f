public class Mathematics {
    static double rounded(double value) {
        return Math.round(value * 1e9) / 1e9;
    }

    public static void main(String[] arguments) {
        System.out.println(Math.abs(-3) + " " + Math.abs(-2.5) + " " + Math.abs(-7L) + " " + Math.abs(-0.0f)); // expect 3 2.5 7 0.0
        System.out.println(Math.min(2, -3) + " " + Math.max(2.5, 3) + " " + Math.min(0.0, -0.0)); // expect -3 3.0 -0.0
        System.out.println(Math.round(2.5) + " " + Math.round(-2.5) + " " + Math.round(2.4f) + " " + Math.round(-0.5)); // expect 3 -2 2 0
        System.out.println(Math.floor(-1.5) + " " + Math.ceil(-1.5) + " " + Math.rint(2.4) + " " + Math.rint(3.5)); // expect -2.0 -1.0 2.0 4.0
        System.out.println(rounded(Math.sqrt(2)) + " " + Math.sqrt(144) + " " + Math.sqrt(-1)); // expect 1.414213562 12.0 NaN
        System.out.println(Math.pow(2, 10) + " " + Math.pow(2, -2) + " " + Math.pow(9, 0.5) + " " + Math.pow(0, 0)); // expect 1024.0 0.25 3.0 1.0
        System.out.println(rounded(Math.sin(1)) + " " + rounded(Math.cos(1)) + " " + rounded(Math.tan(1))); // expect 0.841470985 0.540302306 1.557407725
        System.out.println(rounded(Math.asin(0.5)) + " " + rounded(Math.acos(0.5)) + " " + rounded(Math.atan(2))); // expect 0.523598776 1.047197551 1.107148718
        System.out.println(rounded(Math.atan2(-1, -1)) + " " + Math.atan2(0, 1) + " " + rounded(Math.atan2(1, 0))); // expect -2.35619449 0.0 1.570796327
        System.out.println(rounded(Math.exp(1)) + " " + rounded(Math.log(10)) + " " + Math.log(1) + " " + Math.log(0));
        // expect 2.718281828 2.302585093 0.0 -Infinity
        System.out.println(rounded(Math.toDegrees(Math.PI)) + " " + rounded(Math.toRadians(180))); // expect 180.0 3.141592654
        System.out.println(Math.signum(-3.5) + " " + Math.signum(0.0)); // expect -1.0 0.0
        System.out.println(rounded(Math.sin(1e6)) + " " + rounded(Math.cos(-12345.678))); // expect -0.349993502 0.710119359
        double random = Math.random();
        System.out.println(random >= 0 && random < 1); // expect true
    }
}
