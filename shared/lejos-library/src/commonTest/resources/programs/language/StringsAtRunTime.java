import josx.platform.rcx.TextLCD;

public class StringsAtRunTime {
    static String text(int number, char letter, boolean answer, float decimal, double wide, long clock, Object thing) {
        return "" + number + letter + answer + decimal + wide + clock + thing;
    }

    static String begin(char letter, int number) {
        return letter + "-" + number;
    }

    static String begin(int number, String text) {
        return number + text;
    }

    static String begin(float number, String text) {
        return number + text;
    }

    static String begin(boolean answer, String text) {
        return answer + text;
    }

    public static void main(String[] arguments) {
        String all = text(1, 'b', false, 0.5f, 1.5, 7L, null);
        char[] end = new char[5];
        TextLCD.print(all); // shows: 1bfal
        for (int index = 0; index < end.length; index++) end[index] = all.charAt(all.length() - 5 + index);
        TextLCD.print(end); // shows: 7null
        TextLCD.print(begin('a', -5)); // shows: a--5
        TextLCD.print(begin(12, "x")); // shows: 12x
        TextLCD.print(begin(2.5f, "y")); // shows: 2.5y
        TextLCD.print(begin(true, "z")); // shows: truez
    }
}
