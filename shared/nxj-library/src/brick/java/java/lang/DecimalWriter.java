package java.lang;

/** Turns decimal numbers into texts as leJOS NXJ does, with at most 15 digits of a double and 7 of a float. */
final class DecimalWriter {
    private static final int DIGITS = 15;
    private static final int FLOAT_DIGITS = 7;

    /** From here on, numbers have an exponent of 10. */
    private static final int FIRST_EXPONENT = 7;
    private static final int FIRST_FLOAT_EXPONENT = 6;

    /** The last exponent of 10 of numbers that are written with one because they are small. */
    private static final int LAST_EXPONENT = -4;

    private static final int MOST_CHARACTERS = 25;

    // The logarithm of 2 for 10, times 2 to the 21st or 24th.
    private static final int LOGARITHM_OF_2 = 631305;
    private static final int FLOAT_LOGARITHM_OF_2 = 5050455;

    // What makes the estimated exponent of 10 one too small for some numbers, but never too large for one.
    private static final int MARGIN = 802779;
    private static final int FLOAT_MARGIN = 7334478;

    private DecimalWriter() {
    }

    static String toString(double number) {
        boolean isNegative = Double.doubleToRawLongBits(number) < 0;
        double size = isNegative ? -number : number;
        if (!(size > 0 && size < Double.POSITIVE_INFINITY)) return special(number, isNegative);
        int power = size < Double.MIN_NORMAL ? powerOf2(size * 0x1p62) - 62 : powerOf2(size);
        int exponent = power * LOGARITHM_OF_2 - MARGIN >> 21;
        double scaled = PowersOf10.largestFirst(size, DIGITS - 1 - exponent);
        long digits = (long) (scaled + 0.5);
        if (digits >= 1000000000000000L) {
            exponent++;
            digits = (long) (scaled * 0.1 + 0.5);
        }
        char[] characters = new char[DIGITS];
        int upper = (int) (digits / 10000000);
        int lower = (int) (digits % 10000000);
        int count;
        if (lower == 0) {
            count = writeToLastZeros(upper, characters, 0, DIGITS - 7);
        } else {
            write(upper, characters, 0, DIGITS - 7);
            count = writeToLastZeros(lower, characters, DIGITS - 7, DIGITS);
        }
        return text(isNegative, characters, count, exponent, FIRST_EXPONENT);
    }

    static String toString(float number) {
        boolean isNegative = Float.floatToRawIntBits(number) < 0;
        float size = isNegative ? -number : number;
        if (!(size > 0 && size < Float.POSITIVE_INFINITY)) return special((double) number, isNegative);
        int power = size < Float.MIN_NORMAL ? powerOf2(size * 0x1p31f) - 31 : powerOf2(size);
        int exponent = power * FLOAT_LOGARITHM_OF_2 - FLOAT_MARGIN >> 24;
        float scaled = PowersOf10.largestFirst(size, FLOAT_DIGITS - 1 - exponent);
        int digits = (int) (scaled + 0.5f);
        if (digits >= 10000000) {
            exponent++;
            digits = (int) (scaled * 0.1f + 0.5f);
        }
        char[] characters = new char[FLOAT_DIGITS];
        int count = writeToLastZeros(digits, characters, 0, FLOAT_DIGITS);
        return text(isNegative, characters, count, exponent, FIRST_FLOAT_EXPONENT);
    }

    private static String special(double number, boolean isNegative) {
        if (number != number) return "NaN";
        if (number == 0) return isNegative ? "-0.0" : "0.0";
        return isNegative ? "-Infinity" : "Infinity";
    }

    private static int powerOf2(double number) {
        return (int) (Double.doubleToRawLongBits(number) >> 52) - 1023;
    }

    private static int powerOf2(float number) {
        return (Float.floatToRawIntBits(number) >> 23) - 127;
    }

    /** Writes the last digits of a number to the places from one up to, but not including, another. */
    private static void write(int number, char[] characters, int from, int to) {
        int rest = number;
        for (int place = to - 1; place >= from; place--) {
            characters[place] = (char) ('0' + rest % 10);
            rest /= 10;
        }
    }

    /** Does the same, but leaves out zeros at the end of a number above 0, and gives the place behind the last digit. */
    private static int writeToLastZeros(int number, char[] characters, int from, int to) {
        int rest = number;
        int end = to;
        if (rest % 10000 == 0) {
            rest /= 10000;
            end -= 4;
        }
        for (; rest % 10 == 0; end--) rest /= 10;
        write(rest, characters, from, end);
        return end;
    }

    /** The text of a number of so many digits, the first of which counts 10 to the power of the exponent. */
    private static String text(boolean isNegative, char[] digits, int length, int exponent, int firstExponent) {
        char[] text = new char[MOST_CHARACTERS];
        int place = 0;
        if (isNegative) text[place++] = '-';
        boolean hasExponent = exponent >= firstExponent || exponent <= LAST_EXPONENT;
        int before = hasExponent ? 1 : exponent + 1;
        int count = length;
        if (before > 0) {
            while (count <= before) digits[count++] = '0';
            System.arraycopy(digits, 0, text, place, before);
            place += before;
            text[place++] = '.';
        } else {
            text[place++] = '0';
            text[place++] = '.';
            for (; before < 0; before++) text[place++] = '0';
        }
        System.arraycopy(digits, before, text, place, count - before);
        place += count - before;
        if (!hasExponent) return new String(text, 0, place);
        text[place++] = 'E';
        String power = Integer.toString(exponent);
        power.getChars(0, power.length(), text, place);
        return new String(text, 0, place + power.length());
    }
}
