package java.lang;

/** Reads decimal numbers from texts, and gives the nearest number that there is. */
final class DecimalReader {
    private static final int MOST_DIGITS = 800;

    private final String text;
    private int place;
    private int end;
    private boolean isNegative;

    /** All digits that count. */
    private NaturalNumber digits = new NaturalNumber(0);
    private int count;

    /** The first 15 digits that count, which a double holds exactly. */
    private long start;

    /** The number is the digits times 10 to this power. */
    private int exponent;

    private DecimalReader(String text) {
        if (text == null) throw new NullPointerException();
        this.text = text.trim();
        end = this.text.length();
        if (end == 0) throw new NumberFormatException(text);
        char first = this.text.charAt(0);
        isNegative = first == '-';
        if (isNegative || first == '+') place++;
    }

    static double toDouble(String text) {
        DecimalReader reader = new DecimalReader(text);
        double special = reader.special();
        if (special != 0) return special;
        reader.read();
        double number;
        if (reader.isShort()) {
            number = reader.quick();
        } else {
            number = Double.longBitsToDouble(reader.exact(53, -1074, 0x7FF));
        }
        return reader.isNegative ? -number : number;
    }

    static float toFloat(String text) {
        DecimalReader reader = new DecimalReader(text);
        double special = reader.special();
        if (special != 0) return (float) special;
        reader.read();
        float number;
        double quick = reader.isShort() ? reader.quick() : 0;
        // In the middle between two, the digits that the double lacks can decide; and small numbers have fewer bits.
        if (quick > 1e-30 && (Double.doubleToRawLongBits(quick) & 0x1FFFFFFF) != 0x10000000) {
            number = (float) quick;
        } else {
            number = Float.intBitsToFloat((int) reader.exact(24, -149, 0xFF));
        }
        return reader.isNegative ? -number : number;
    }

    /** NaN or infinity, or 0 if it is an ordinary number. */
    private double special() {
        String word = text.substring(place);
        if (word.equals("NaN")) return Double.NaN;
        if (!word.equals("Infinity")) return 0;
        return isNegative ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
    }

    private void read() {
        boolean hasDigits = false;
        boolean isBehindPoint = false;
        for (; place < end; place++) {
            char character = text.charAt(place);
            if (character == '.' && !isBehindPoint) {
                isBehindPoint = true;
            } else if (Character.isDigit(character)) {
                hasDigits = true;
                add(character - '0');
                if (isBehindPoint) exponent--;
            } else {
                break;
            }
        }
        if (!hasDigits) throw new NumberFormatException(text);
        if (place < end && (text.charAt(place) == 'e' || text.charAt(place) == 'E')) readExponent();
        if (place < end && "fFdD".indexOf(text.charAt(place)) >= 0) place++;
        if (place < end) throw new NumberFormatException(text);
    }

    private void add(int digit) {
        if (count == 0 && digit == 0) return;
        count++;
        if (count <= 15) start = 10 * start + digit;
        if (count <= MOST_DIGITS) {
            if (count == 1) digits = new NaturalNumber(digit);
            else digits.multiply(10, digit);
        } else {
            // What is cut off makes the number larger, but not more than its last digit can say.
            if (count == MOST_DIGITS + 1) digits.multiply(10, 1);
            else exponent++;
        }
    }

    private void readExponent() {
        place++;
        boolean isBelowZero = place < end && text.charAt(place) == '-';
        if (isBelowZero || place < end && text.charAt(place) == '+') place++;
        int first = place;
        int power = 0;
        for (; place < end && Character.isDigit(text.charAt(place)); place++) {
            if (power < 100000) power = 10 * power + text.charAt(place) - '0';
        }
        if (place == first) throw new NumberFormatException(text);
        exponent += isBelowZero ? -power : power;
    }

    private boolean isShort() {
        return count <= 15 && exponent >= -22 && exponent <= 22;
    }

    private double quick() {
        double[] powers = DecimalWriter.POWERS_OF_10;
        return exponent < 0 ? start / powers[-exponent] : start * powers[exponent];
    }

    /** The bits of the nearest number that has so many bits, the lowest of which is 2 to the least power. */
    private long exact(int bits, int least, int infinity) {
        if (digits.isZero() || count + exponent < -330) return 0;
        if (count + exponent > 310) return (long) infinity << bits - 1;
        NaturalNumber above = digits;
        NaturalNumber below = new NaturalNumber(1);
        if (exponent > 0) {
            above.multiplyByPowerOf10(exponent);
        } else {
            below.multiplyByPowerOf10(-exponent);
        }
        int shift = bits - (above.bitLength() - below.bitLength());
        if (isTooLarge(above, below, shift, bits)) shift--;
        if (shift > -least) shift = -least;
        if (shift > 0) {
            above.shiftLeft(shift);
        } else {
            below.shiftLeft(-shift);
        }
        below.shiftLeft(bits - 1);
        long result = 0;
        for (int bit = 0; bit < bits; bit++) {
            result <<= 1;
            if (above.compareTo(below) >= 0) {
                above.subtract(below);
                result++;
            }
            above.shiftLeft(1);
        }
        int half = above.compareTo(below);
        if (half > 0 || half == 0 && (result & 1) == 1) result++;
        // Numbers that do not have all their bits have the exponent 0, like those of exponent 1 without the first bit.
        long field = -shift - least;
        long highest = (long) infinity << bits - 1;
        if (field >= infinity) return highest;
        long number = (field << bits - 1) + result;
        return number >= highest ? highest : number;
    }

    /** Whether above times 2 to a power, divided by below, has more bits. */
    private static boolean isTooLarge(NaturalNumber above, NaturalNumber below, int shift, int bits) {
        NaturalNumber a = above.copy();
        NaturalNumber b = below.copy();
        if (shift > 0) {
            a.shiftLeft(shift);
        } else {
            b.shiftLeft(-shift);
        }
        b.shiftLeft(bits);
        return a.compareTo(b) >= 0;
    }
}
