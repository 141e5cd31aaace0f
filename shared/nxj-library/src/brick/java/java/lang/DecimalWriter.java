package java.lang;

/** Turns decimal numbers into the shortest texts from which the same numbers can be read. */
final class DecimalWriter {
    /** The powers of 10 that a double holds exactly. */
    static final double[] POWERS_OF_10 = {
        1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19,
        1e20, 1e21, 1e22};

    private static final int MOST_DIGITS = 18;

    /** The digits, as characters. */
    private final char[] digits = new char[MOST_DIGITS];
    private int count;

    /** The digits stand behind a point, times 10 to this power. */
    private int exponent;

    private DecimalWriter() {
    }

    static String toString(double number) {
        String special = special(number);
        if (special != null) return special;
        double size = number < 0 ? -number : number;
        DecimalWriter writer = new DecimalWriter();
        if (!writer.findShort(size, 15, false)) {
            long bits = Double.doubleToRawLongBits(size);
            int power = (int) (bits >> 52);
            long mantissa = bits & 0xFFFFFFFFFFFFFL;
            if (power == 0) {
                writer.find(mantissa, -1074, false);
            } else {
                writer.find(mantissa | 0x10000000000000L, power - 1075, mantissa == 0 && power > 1);
            }
        }
        return writer.text(number < 0);
    }

    static String toString(float number) {
        String special = special(number);
        if (special != null) return special;
        float size = number < 0 ? -number : number;
        DecimalWriter writer = new DecimalWriter();
        if (!writer.findShort(size, 6, true)) {
            int bits = Float.floatToRawIntBits(size);
            int power = bits >> 23;
            int mantissa = bits & 0x7FFFFF;
            if (power == 0) {
                writer.find(mantissa, -149, false);
            } else {
                writer.find(mantissa | 0x800000, power - 150, mantissa == 0 && power > 1);
            }
        }
        return writer.text(number < 0);
    }

    private static String special(double number) {
        if (number != number) return "NaN";
        if (number == 0) return 1 / number < 0 ? "-0.0" : "0.0";
        if (number == Double.POSITIVE_INFINITY) return "Infinity";
        return number == Double.NEGATIVE_INFINITY ? "-Infinity" : null;
    }

    /** Finds digits quickly if few are enough, as for most numbers that people write. */
    private boolean findShort(double number, int most, boolean isFloat) {
        int power = (int) (Double.doubleToRawLongBits(number) >> 52) - 1023;
        int place = (power * 1233 >> 12) + 1;
        if (place < -6 || place > 22) return false;
        if (place < 0 ? number * POWERS_OF_10[-place] >= 1 : number >= POWERS_OF_10[place]) place++;
        int scale = most - place;
        if (scale > 22 || scale < -22) return false;
        double scaled = scale < 0 ? number / POWERS_OF_10[-scale] : number * POWERS_OF_10[scale];
        long whole = (long) (scaled + 0.5);
        double back = scale < 0 ? whole * POWERS_OF_10[-scale] : whole / POWERS_OF_10[scale];
        if (isFloat ? (float) back != (float) number : back != number) return false;
        if (isFloat && (Double.doubleToRawLongBits(back) & 0x1FFFFFFF) == 0x10000000) return false;
        String text = Long.toString(whole);
        count = text.length();
        text.getChars(0, count, digits, 0);
        exponent = place + count - most;
        return true;
    }

    /**
     * Finds the digits of mantissa times a power of 2.
     *
     * @param isUneven whether the next number below is nearer than the one above.
     */
    private void find(long mantissa, int power, boolean isUneven) {
        NaturalNumber rest = new NaturalNumber(mantissa);
        NaturalNumber unit = new NaturalNumber(1);
        NaturalNumber down = new NaturalNumber(1);
        int bits = rest.bitLength() + power;
        exponent = (int) Math.floor((bits - 1) * 0.30102999566398) + 1;
        // The number is rest / unit, and down / unit is half the way to the next number below.
        rest.shiftLeft((power > 0 ? power : 0) + (isUneven ? 2 : 1));
        down.shiftLeft(power > 0 ? power : 0);
        unit.shiftLeft((power < 0 ? -power : 0) + (isUneven ? 2 : 1));
        if (exponent > 0) {
            unit.multiplyByPowerOf10(exponent);
        } else {
            rest.multiplyByPowerOf10(-exponent);
            down.multiplyByPowerOf10(-exponent);
        }
        if (rest.compareTo(unit) >= 0) {
            unit.multiply(10, 0);
            exponent++;
        }
        NaturalNumber up = down;
        if (isUneven) {
            up = down.copy();
            up.multiply(2, 0);
        }
        boolean isEven = (mantissa & 1) == 0;
        boolean isLow;
        boolean isHigh;
        do {
            rest.multiply(10, 0);
            down.multiply(10, 0);
            if (up != down) up.multiply(10, 0);
            int digit = 0;
            while (rest.compareTo(unit) >= 0) {
                rest.subtract(unit);
                digit++;
            }
            digits[count++] = (char) ('0' + digit);
            int low = rest.compareTo(down);
            int high = rest.compareSumTo(up, unit);
            isLow = low < 0 || isEven && low == 0;
            isHigh = high > 0 || isEven && high == 0;
        } while (count < 2 || !isLow && !isHigh);
        int half = rest.compareSumTo(rest, unit);
        boolean isOdd = (digits[count - 1] & 1) == 1;
        if (isHigh && (!isLow || half > 0 || half == 0 && isOdd)) roundUp();
    }

    private void roundUp() {
        int place = count - 1;
        while (place >= 0 && digits[place] == '9') digits[place--] = '0';
        if (place >= 0) {
            digits[place]++;
        } else {
            digits[0] = '1';
            exponent++;
        }
    }

    private String text(boolean isNegative) {
        while (count > 1 && digits[count - 1] == '0') count--;
        StringBuilder text = new StringBuilder(26);
        if (isNegative) text.append('-');
        if (exponent > 7 || exponent < -2) {
            appendDigits(text, 0, 1);
            text.append('.');
            appendDigits(text, 1, count > 2 ? count : 2);
            return text.append('E').append(exponent - 1).toString();
        }
        if (exponent <= 0) text.append('0');
        appendDigits(text, 0, exponent);
        text.append('.');
        appendDigits(text, exponent, count > exponent + 1 ? count : exponent + 1);
        return text.toString();
    }

    private void appendDigits(StringBuilder text, int from, int to) {
        for (int place = from; place < to; place++) text.append(place >= 0 && place < count ? digits[place] : '0');
    }
}
