/** Texts of decimal numbers take one to two milliseconds each, and functions of Math half of one or one. */
public class DecimalCosts { // only here
    static int length;
    static double sum;

    public static void main(String[] arguments) {
        for (int i = 1; i <= 200; i++) length += (i / 7.0 + "").length();
        for (int i = 1; i <= 200; i++) length += (i * 0.25 + "").length();
        for (int i = 1; i <= 200; i++) length += (i * 0.2f + "").length();
        for (int i = 1; i <= 200; i++) sum += Math.sin(i * 0.02) + Math.sqrt(i) + Math.atan2(i, 9) + Math.pow(1.02, i);
        for (int i = 1; i <= 200; i++) sum += Double.parseDouble("12.75");
        System.out.println(length + " " + (sum > 0)); // expect 4498 true
        // takes 1800
    }
}
