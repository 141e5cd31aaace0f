/** Decimal numbers as leJOS NXJ reads them. */
public class DecimalReading { // only here
    static String read(String text) {
        try {
            return "" + Double.parseDouble(text);
        } catch (NumberFormatException wrong) {
            return "no";
        }
    }

    static String readFloat(String text) {
        try {
            return "" + Float.parseFloat(text);
        } catch (NumberFormatException wrong) {
            return "no";
        }
    }

    static boolean isRead(String text, double number) {
        return Double.parseDouble(text) == number;
    }

    public static void main(String[] arguments) {
        String[] texts = {"7", "-7.5", "+.25", "3.", "2e3", "-1E-2", "1e+2", "00012", "NaN", "-NaN", "Infinity", "-Infinity",
            "", "-", ".", "e5", "1e", "1e+", "1.2.3", "--1", " 1", "1 ", "1.5f", "2d", "0x1p3", "1e4.5", "nan", "1,5"};
        String all = "";
        String floats = "";
        for (String text : texts) {
            all += read(text) + " ";
            floats += readFloat(text) + " ";
        }
        System.out.println(all.trim()); // expect 7.0 -7.5 0.25 3.0 2000.0 -0.01 100.0 12.0 NaN NaN Infinity -Infinity no no no no no no no no no no no no no no no no
        System.out.println(floats.equals(all)); // expect true
        // The digits are multiplied by powers of 10 one after another, so the last bit can be another than in Java.
        System.out.println(isRead("0.5", 0.5) + " " + isRead("1.1", 1.1)); // expect true true
        System.out.println(isRead("0.3", 0.3) + " " + isRead("99.99", 99.99)); // expect false false
        System.out.println(isRead("0.3", 3 * 0.1)); // expect true
        System.out.println(read("0.3") + " " + read("99.99")); // expect 0.3 99.99
        // Nineteen digits count, and of a float nine or ten.
        System.out.println(read("12345678901234567890123") + " " + readFloat("98765432109876")); // expect 1.23456789012346E22 9.876544E13
        System.out.println(read("1e308") + " " + read("1e309") + " " + read("1e-320") + " " + read("1e-351")); // expect 1.0E308 Infinity 9.99988867182683E-321 0.0
        System.out.println(readFloat("3e38") + " " + readFloat("1e39") + " " + readFloat("1e-61")); // expect 3.0E38 Infinity 0.0
        System.out.println(read("0e400") + " " + read("-0") + " " + read("-1e-999999999999")); // expect Infinity -0.0 -0.0
        try {
            Double.parseDouble(null);
        } catch (NullPointerException wrong) {
            System.out.println("no text"); // expect no text
        }
        try {
            Double.valueOf("x");
        } catch (NumberFormatException wrong) {
            System.out.println(wrong.getMessage()); // expect null
        }
        try {
            Integer.parseInt("12a");
        } catch (NumberFormatException wrong) {
            System.out.println(wrong.getMessage()); // expect illegal digit character
        }
        try {
            Long.parseLong("9223372036854775808");
        } catch (NumberFormatException wrong) {
            System.out.println(wrong.getMessage()); // expect number is too big
        }
        try {
            Integer.parseInt("-");
        } catch (NumberFormatException wrong) {
            System.out.println(wrong.getMessage()); // expect string doesn't contain any digits
        }
        try {
            Integer.parseInt("1", 99);
        } catch (NumberFormatException wrong) {
            System.out.println(wrong.getMessage()); // expect given radix is invalid
        }
    }
}
