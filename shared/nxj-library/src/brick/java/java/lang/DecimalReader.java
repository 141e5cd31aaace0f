package java.lang;

/** Reads decimal numbers from texts as leJOS NXJ does: without blanks around them, and without F or D at the end. */
final class DecimalReader {
    /** Numbers up to these take one more digit; further digits do not count. */
    private static final long MOST = (Long.MAX_VALUE - 9) / 10;
    private static final long FLOAT_MOST = (Integer.MAX_VALUE - 9) / 10;

    /** Powers of 10 beyond these are infinite or 0. */
    private static final int HIGHEST_POWER = 350;
    private static final int HIGHEST_FLOAT_POWER = 60;

    private final char[] characters;
    private final boolean isNegative;
    private int place;

    /** The number is the digits times 10 to this power. */
    private long digits;
    private int exponent;

    private DecimalReader(String text) {
        characters = text.toCharArray();
        if (characters.length == 0) throw new NumberFormatException();
        char first = characters[0];
        isNegative = first == '-';
        if (isNegative || first == '+') place++;
    }

    static double toDouble(String text) {
        DecimalReader reader = new DecimalReader(text);
        double size;
        if (reader.says("NaN")) {
            return Double.NaN;
        } else if (reader.says("Infinity") || reader.read(MOST, HIGHEST_POWER) > HIGHEST_POWER) {
            size = Double.POSITIVE_INFINITY;
        } else if (reader.exponent < -HIGHEST_POWER) {
            size = 0;
        } else {
            size = PowersOf10.smallestFirst((double) reader.digits, reader.exponent);
        }
        return reader.isNegative ? -size : size;
    }

    static float toFloat(String text) {
        DecimalReader reader = new DecimalReader(text);
        float size;
        if (reader.says("NaN")) {
            return Float.NaN;
        } else if (reader.says("Infinity") || reader.read(FLOAT_MOST, HIGHEST_FLOAT_POWER) > HIGHEST_FLOAT_POWER) {
            size = Float.POSITIVE_INFINITY;
        } else if (reader.exponent < -HIGHEST_FLOAT_POWER) {
            size = 0;
        } else {
            size = PowersOf10.smallestFirst((float) reader.digits, reader.exponent);
        }
        return reader.isNegative ? -size : size;
    }

    /** Whether the word, and nothing more, stands behind the sign. */
    private boolean says(String word) {
        int length = word.length();
        if (characters.length - place != length) return false;
        for (int index = 0; index < length; index++) {
            if (characters[place + index] != word.charAt(index)) return false;
        }
        return true;
    }

    /** Reads an ordinary number, and gives its power of 10. */
    private int read(long most, int highestPower) {
        int first = place;
        int behindPoint = 0;
        int count = 0;
        for (; place < characters.length; place++) {
            char character = characters[place];
            if (character == '.' && behindPoint == 0) {
                behindPoint = 1;
                first++;
            } else if (character >= '0' && character <= '9') {
                if (digits <= most) {
                    digits = digits * 10 + (character - '0');
                    count += behindPoint;
                } else {
                    count += behindPoint - 1;
                }
            } else {
                break;
            }
        }
        if (place == first) throw new NumberFormatException();
        exponent = -count;
        if (place < characters.length) readExponent(highestPower);
        return exponent;
    }

    private void readExponent(int highestPower) {
        char letter = characters[place++];
        if (letter != 'e' && letter != 'E') throw new NumberFormatException();
        boolean isBelowZero = place < characters.length && characters[place] == '-';
        if (isBelowZero || place < characters.length && characters[place] == '+') place++;
        if (place == characters.length) throw new NumberFormatException();
        int start = isBelowZero ? -exponent : exponent;
        int power = 0;
        for (; place < characters.length; place++) {
            char character = characters[place];
            if (character < '0' || character > '9') throw new NumberFormatException();
            if (power + start < highestPower) power = power * 10 + (character - '0');
        }
        exponent = isBelowZero ? -(power + start) : power + start;
    }
}
