import josx.platform.rcx.LCD;

public class NumbersAsText {
    static void check(String expected, String actual) {
        LCD.showNumber(actual.equals(expected) ? 1 : 0); // shows: 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1
    }

    static String text(int number) {
        return "" + number;
    }

    static String text(float number) {
        return "" + number;
    }

    static String text(double number) {
        return "" + number;
    }

    public static void main(String[] arguments) {
        check("0", Integer.toString(0));
        check("-2147483648", Integer.toString(Integer.MIN_VALUE));
        check("2147483647", new Integer(Integer.MAX_VALUE).toString());
        check("10", text(10));
        check("0.0", text(0f));
        check("1.0", text(1f));
        check("2.5", text(2.5f));
        check("-0.125", text(-0.125f));
        check("0.1", text(0.1f));
        check("3.1415927", text((float) Math.PI));
        check("0.33333334", text(1f / 3f));
        check("0.7", text(0.7f));
        check("123456.7", text(123456.7f));
        check("9999999.0", text(9999999f));
        check("-1.2345678E-4", text(-1.23456789e-4f));
        check("3.4028236E38", text(3.4028235e38f));
        check("1234567.0", text(1234567f));
        check("1.5E10", text(1.5e10f));
        check("2.5E-4", text(2.5e-4f));
        check("Infinity", text(1f / 0f));
        check("-Infinity", text(-1f / 0f));
        check("100.0", text(100.0));
        check("9", new String(StringUtils.getCharacters(9), 0, 1));
    }
}
