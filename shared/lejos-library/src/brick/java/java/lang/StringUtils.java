package java.lang;

/**
 * Helps texts: it writes numbers in decimal figures.
 *
 * <p>A decimal number is written with at least one figure behind the point, with E and a power of ten below 0.001 and from ten million on, and
 * with no more than eight figures. The last ones may be wrong, as on any 32-bit brick. There is no minus before 0.0.
 */
public final class StringUtils {
    /** A decimal number is written with at most so many figures. */
    private static final int MOST_FIGURES = 8;

    /** Any decimal number needs at most so many characters. */
    private static final int LONGEST = 16;

    private StringUtils() {
    }

    /** Gives the characters of a text itself, not a copy: who changes them changes the text. */
    public static char[] getCharacters(String text) {
        return text.characters;
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

    /** Gives a decimal number as characters, with at most eight figures, such as 2.5 or 1.5E10. */
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
        if (size == 0f || size >= 1.0E-3f && size < 1.0E7f) return writePlain(size, buffer, count);
        int exponent = 0;
        // Powers of ten up to the tenth are exact, so that there is but one error for ten places.
        while (size >= 10f) {
            float power = 10f;
            int places = 1;
            while (places < 10 && size / power >= 10f) {
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
        count = writePlain(size, buffer, count);
        buffer[count++] = 'E';
        return copy(getCharacters(exponent), buffer, count);
    }

    /** Writes a number below ten million figure by figure; the zeros before the first one do not count. */
    private static int writePlain(float size, char[] buffer, int first) {
        int whole = (int) size;
        int count = copy(getCharacters(whole), buffer, first);
        int figures = whole == 0 ? 0 : count - first;
        buffer[count++] = '.';
        int end = count + 1;
        float rest = size - whole;
        do {
            rest *= 10f;
            int figure = (int) rest;
            rest -= figure;
            buffer[count++] = (char) ('0' + figure);
            if (figure != 0 || figures > 0) figures++;
            if (figure != 0) end = count;
        } while (rest > 0f && figures < MOST_FIGURES);
        return end;
    }

    private static int copy(String text, char[] buffer, int first) {
        return copy(text.characters, buffer, first);
    }

    private static int copy(char[] text, char[] buffer, int first) {
        System.arraycopy(text, 0, buffer, first, text.length);
        return first + text.length;
    }
}
