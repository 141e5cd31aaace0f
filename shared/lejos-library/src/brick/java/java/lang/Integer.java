package java.lang;

/**
 * A whole number as an object.
 *
 * <p>A brick's has no intValue and equals only itself: what it can do is become text. To keep numbers and get them back, use an int[].
 */
public final class Integer {
    /** The smallest whole number there is: -2147483648. */
    public static final int MIN_VALUE = 0x80000000;

    /** The largest whole number there is: 2147483647. */
    public static final int MAX_VALUE = 0x7FFFFFFF;

    private final int value;

    /** Makes an object of a whole number. */
    public Integer(int value) {
        this.value = value;
    }

    /** Gives a whole number as text. */
    public static String toString(int number) {
        char[] characters = StringUtils.getCharacters(number);
        return new String(characters, 0, characters.length);
    }

    /** Gives the number as text. */
    public String toString() {
        return toString(value);
    }
}
