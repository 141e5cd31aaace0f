package java.lang;

/** A character as an object. */
public final class Character implements Comparable<Character> {
    /** The lowest character. */
    public static final char MIN_VALUE = '\u0000';

    /** The highest character. */
    public static final char MAX_VALUE = '\uFFFF';

    /** The number of bits. */
    public static final int SIZE = 16;

    /** The smallest system of digits. */
    public static final int MIN_RADIX = 2;

    /** The largest system of digits: 0 to 9 and a to z. */
    public static final int MAX_RADIX = 36;

    /** The first half of a pair that stands for one character: the lowest one. */
    public static final char MIN_HIGH_SURROGATE = '\uD800';

    /** The first half of a pair that stands for one character: the highest one. */
    public static final char MAX_HIGH_SURROGATE = '\uDBFF';

    /** The second half of a pair that stands for one character: the lowest one. */
    public static final char MIN_LOW_SURROGATE = '\uDC00';

    /** The second half of a pair that stands for one character: the highest one. */
    public static final char MAX_LOW_SURROGATE = '\uDFFF';

    /** The lowest half of a pair. */
    public static final char MIN_SURROGATE = MIN_HIGH_SURROGATE;

    /** The highest half of a pair. */
    public static final char MAX_SURROGATE = MAX_LOW_SURROGATE;

    /** The lowest number of a character. */
    public static final int MIN_CODE_POINT = 0;

    /** The lowest number of a character that needs a pair. */
    public static final int MIN_SUPPLEMENTARY_CODE_POINT = 0x10000;

    /** The highest number of a character. */
    public static final int MAX_CODE_POINT = 0x10FFFF;

    /** The class of the plain values, char.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Character> TYPE = (Class<Character>) char[].class.getComponentType();

    private final char value;

    /** Makes an object of the character. */
    public Character(char value) {
        this.value = value;
    }

    /** Gives an object of the character. */
    public static Character valueOf(char value) {
        return new Character(value);
    }

    /** Gives the character as text. */
    public static String toString(char value) {
        return String.valueOf(value);
    }

    /** Says whether it is one of 0 to 9. */
    public static boolean isDigit(char value) {
        return value >= '0' && value <= '9';
    }

    /** Gives the number that a digit stands for in a system of so many digits, or -1 if it is none. */
    public static int digit(char digit, int radix) {
        return digit((int) digit, radix);
    }

    /** Gives the number that a digit stands for in a system of so many digits, or -1 if it is none. */
    public static int digit(int digit, int radix) {
        int number = -1;
        if (digit >= '0' && digit <= '9') number = digit - '0';
        if (digit >= 'a' && digit <= 'z') number = digit - 'a' + 10;
        if (digit >= 'A' && digit <= 'Z') number = digit - 'A' + 10;
        return number < radix && radix >= MIN_RADIX && radix <= MAX_RADIX ? number : -1;
    }

    /** Gives the digit of a number in a system of so many digits; the character 0 if there is none. */
    public static char forDigit(int number, int radix) {
        if (number < 0 || number >= radix || radix < MIN_RADIX || radix > MAX_RADIX) return 0;
        return (char) (number < 10 ? '0' + number : 'a' - 10 + number);
    }

    /** Says whether it is the first half of a pair. */
    public static boolean isHighSurrogate(char value) {
        return value >= MIN_HIGH_SURROGATE && value <= MAX_HIGH_SURROGATE;
    }

    /** Says whether it is the second half of a pair. */
    public static boolean isLowSurrogate(char value) {
        return value >= MIN_LOW_SURROGATE && value <= MAX_LOW_SURROGATE;
    }

    /** Says whether both together stand for one character. */
    public static boolean isSurrogatePair(char high, char low) {
        return isHighSurrogate(high) && isLowSurrogate(low);
    }

    /** Says whether a character can have this number. */
    public static boolean isValidCodePoint(int number) {
        return number >= MIN_CODE_POINT && number <= MAX_CODE_POINT;
    }

    /** Says whether the character with this number needs a pair. */
    public static boolean isSupplementaryCodePoint(int number) {
        return number >= MIN_SUPPLEMENTARY_CODE_POINT && number <= MAX_CODE_POINT;
    }

    /** Gives 2 if the character with this number needs a pair, and otherwise 1. */
    public static int charCount(int number) {
        return number < MIN_SUPPLEMENTARY_CODE_POINT ? 1 : 2;
    }

    /** Gives the number of the character that a pair stands for. */
    public static int toCodePoint(char high, char low) {
        return (high - MIN_HIGH_SURROGATE << 10) + (low - MIN_LOW_SURROGATE) + MIN_SUPPLEMENTARY_CODE_POINT;
    }

    /** Gives the character with this number, or its pair. */
    public static char[] toChars(int number) {
        char[] characters = new char[charCount(number)];
        toChars(number, characters, 0);
        return characters;
    }

    /** Writes the character with this number, or its pair, into the array, and gives how many it wrote. */
    public static int toChars(int number, char[] characters, int place) {
        if (!isValidCodePoint(number)) throw new IllegalArgumentException();
        int count = charCount(number);
        if (count == 1) {
            characters[place] = (char) number;
        } else {
            int rest = number - MIN_SUPPLEMENTARY_CODE_POINT;
            characters[place] = (char) (MIN_HIGH_SURROGATE + (rest >> 10));
            characters[place + 1] = (char) (MIN_LOW_SURROGATE + (rest & 0x3FF));
        }
        return count;
    }

    /** Gives the character with its two bytes swapped. */
    public static char reverseBytes(char value) {
        return (char) (value << 8 | value >> 8);
    }

    /** Gives the character. */
    public char charValue() {
        return value;
    }

    /** Gives a number below 0 if this character comes before the other one, and above 0 if it comes after it. */
    public int compareTo(Character other) {
        return value - other.value;
    }

    /** Says whether both are the same character. */
    public boolean equals(Object other) {
        return other instanceof Character && ((Character) other).value == value;
    }

    /** Gives a number that is the same for the same character. */
    public int hashCode() {
        return value;
    }

    /** Gives the character as text. */
    public String toString() {
        return String.valueOf(value);
    }

    /** Gives the number of the character at a place, with the other half if it is the first one of a pair. */
    public static int codePointAt(CharSequence text, int place) {
        char first = text.charAt(place);
        if (isHighSurrogate(first) && place + 1 < text.length()) {
            char second = text.charAt(place + 1);
            if (isLowSurrogate(second)) return toCodePoint(first, second);
        }
        return first;
    }

    /** Gives the number of the character at a place, with the other half if it is the first one of a pair. */
    public static int codePointAt(char[] characters, int place) {
        return codePointAt(characters, place, characters.length);
    }

    /** Does the same; nothing from a place on counts. */
    public static int codePointAt(char[] characters, int place, int end) {
        char first = characters[place];
        boolean isPair = isHighSurrogate(first) && place + 1 < end && isLowSurrogate(characters[place + 1]);
        return isPair ? toCodePoint(first, characters[place + 1]) : first;
    }

    /** Gives the number of the character before a place, with the other half if it is the second one of a pair. */
    public static int codePointBefore(CharSequence text, int place) {
        char second = text.charAt(place - 1);
        if (isLowSurrogate(second) && place > 1) {
            char first = text.charAt(place - 2);
            if (isHighSurrogate(first)) return toCodePoint(first, second);
        }
        return second;
    }

    /** Gives the number of the character before a place, with the other half if it is the second one of a pair. */
    public static int codePointBefore(char[] characters, int place) {
        return codePointBefore(characters, place, 0);
    }

    /** Does the same; nothing before another place counts. */
    public static int codePointBefore(char[] characters, int place, int start) {
        char second = characters[place - 1];
        boolean isPair = isLowSurrogate(second) && place - 2 >= start && isHighSurrogate(characters[place - 2]);
        return isPair ? toCodePoint(characters[place - 2], second) : second;
    }
}
