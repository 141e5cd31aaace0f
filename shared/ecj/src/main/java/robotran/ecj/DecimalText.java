package robotran.ecj;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/**
 * Formats floating-point numbers for ECJ's constant strings, with the fewest digits that identify them, but at least
 * two; the build makes ECJ call these methods. Older and newer versions of Java differ in the last digit.
 */
public final class DecimalText {
    /** This many digits distinguish any two doubles. */
    private static final int DIGITS = 17;

    private static final BigDecimal PLAIN_FROM = new BigDecimal("0.001");
    private static final BigDecimal PLAIN_UNTIL = new BigDecimal("10000000");

    private DecimalText() {}

    public static String of(double number) {
        return special(number) ? String.valueOf(number) : text(number, false);
    }

    public static String of(float number) {
        return special(number) ? String.valueOf(number) : text(number, true);
    }

    private static boolean special(double number) {
        return number == 0 || number != number || Math.abs(number) == Double.POSITIVE_INFINITY;
    }

    private static String text(double number, boolean isFloat) {
        BigDecimal shortest = shortest(Math.abs(number), isFloat).stripTrailingZeros();
        String sign = number < 0 ? "-" : "";
        if (shortest.compareTo(PLAIN_FROM) >= 0 && shortest.compareTo(PLAIN_UNTIL) < 0) {
            String plain = shortest.toPlainString();
            return sign + plain + (plain.indexOf('.') < 0 ? ".0" : "");
        }
        String digits = shortest.unscaledValue().toString();
        int exponent = digits.length() - shortest.scale() - 1;
        return sign + digits.charAt(0) + "." + (digits.length() == 1 ? "0" : digits.substring(1)) + "E" + exponent;
    }

    private static BigDecimal shortest(double number, boolean isFloat) {
        BigDecimal exact = new BigDecimal(number);
        for (int digits = 2; digits < DIGITS; digits++) {
            BigDecimal rounded = exact.round(new MathContext(digits, RoundingMode.HALF_EVEN));
            String text = rounded.unscaledValue() + "e" + -rounded.scale();
            if ((isFloat ? DecimalReader.floatOf(text) : DecimalReader.doubleOf(text)) == number) {
                return rounded;
            }
        }
        return exact.round(new MathContext(DIGITS, RoundingMode.HALF_EVEN));
    }
}
