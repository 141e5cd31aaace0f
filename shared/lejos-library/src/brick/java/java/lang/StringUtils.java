package java.lang;

/**
 * Helps texts: it writes numbers in decimal figures.
 *
 * <p>A decimal number is written as Java on a computer does, with at least one figure behind the point, and with E and a power of ten below
 * 0.001 and from ten million on, but with no more than seven figures. The last of them may be wrong, as on any 32-bit brick. There is
 * no minus before 0.0.
 */
public final class StringUtils {
    /** Any decimal number needs at most so many characters. */
    private static final int LONGEST = 16;

    private StringUtils() {
    }

    /** Gives a whole number as characters. */
    public static char[] getCharacters(int number) {
        int rest = number;
        int count = number < 0 ? 2 : 1;
        while (rest > 9 || rest < -9) {
            rest = rest / 10;
            count++;
        }
        char[] characters = new char[count];
        rest = number;
        int place = count;
        do {
            int figure = rest % 10;
            characters[--place] = (char) ('0' + (figure < 0 ? -figure : figure));
            rest = rest / 10;
        } while (rest != 0);
        if (number < 0) characters[0] = '-';
        return characters;
    }

    /** Gives a decimal number as characters, with at most seven figures, such as 2.5 or 1.5E10. */
    public static char[] getCharacters(float number) {
        char[] buffer = new char[LONGEST];
        int count = write(number, buffer);
        char[] characters = new char[count];
        System.arraycopy(buffer, 0, characters, 0, count);
        return characters;
    }

    private static int write(float number, char[] buffer) {
        int bits = Float.floatToIntBits(number);
        int count = 0;
        if ((bits & 0x7F800000) == 0x7F800000) {
            if ((bits & 0x007FFFFF) != 0) return copy("NaN", buffer, 0);
            if (bits < 0) buffer[count++] = '-';
            return copy("Infinity", buffer, count);
        }
        if (bits < 0 && number != 0f) buffer[count++] = '-';
        float size = number < 0f ? -number : number;
        if (size == 0f) return copy("0.0", buffer, count);
        int exponent = 0;
        if (size < 1.0E-3f || size >= 1.0E7f) {
            // Powers of ten up to the tenth are exact, so that there is but one error for ten places.
            while (size >= 1.0E9f) {
                float power = 10f;
                int places = 1;
                while (places < 10 && size / power >= 1.0E9f) {
                    power *= 10f;
                    places++;
                }
                size /= power;
                exponent += places;
            }
            while (size < 1f) {
                float power = 10f;
                int places = 1;
                while (places < 10 && size * power < 1f) {
                    power *= 10f;
                    places++;
                }
                size *= power;
                exponent -= places;
            }
            int before = wholeFigures(size) - 1;
            exponent += before;
            count = writePlain(size, before, buffer, count);
            buffer[count++] = 'E';
            return copy(getCharacters(exponent), buffer, count);
        }
        return writePlain(size, 0, buffer, count);
    }

    /** How many figures stand before the point. */
    private static int wholeFigures(float size) {
        int figures = 1;
        float bound = 10f;
        while (size >= bound) {
            figures++;
            bound *= 10f;
        }
        return figures;
    }

    /** Writes a number with the point moved so many places to the left. */
    private static int writePlain(float size, int moved, char[] buffer, int first) {
        float power = 1f;
        int decimals = 0;
        while (size * power < 1000000f) {
            power *= 10f;
            decimals++;
        }
        float scaled = size * power;
        int figures = (int) scaled;
        if (scaled - figures >= 0.5f) figures++;
        int fraction = decimals + moved;
        while (figures >= 10000000) {
            figures = (figures + 5) / 10;
            fraction--;
        }
        while (fraction > 1 && figures % 10 == 0) {
            figures = figures / 10;
            fraction--;
        }
        return place(figures, fraction, buffer, first);
    }

    private static int place(int figures, int fraction, char[] buffer, int first) {
        char[] written = getCharacters(figures);
        int whole = written.length - fraction;
        int count = first;
        if (whole <= 0) buffer[count++] = '0';
        for (int index = 0; index < whole; index++) buffer[count++] = written[index];
        buffer[count++] = '.';
        for (int zero = whole; zero < 0; zero++) buffer[count++] = '0';
        for (int index = whole < 0 ? 0 : whole; index < written.length; index++) buffer[count++] = written[index];
        if (fraction == 0) buffer[count++] = '0';
        return count;
    }

    private static int copy(String text, char[] buffer, int first) {
        return copy(text.characters, buffer, first);
    }

    private static int copy(char[] text, char[] buffer, int first) {
        System.arraycopy(text, 0, buffer, first, text.length);
        return first + text.length;
    }
}
