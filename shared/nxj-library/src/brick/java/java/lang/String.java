package java.lang;

/** A text, which never changes. */
public final class String implements CharSequence, Comparable<String> {
    // The virtual machine makes the texts that stand in a program, so there is no other field.
    final char[] characters;

    /** Makes an empty text. */
    public String() {
        this(0);
    }

    /** Makes a text of characters. */
    public String(char[] characters) {
        this(characters, 0, characters.length);
    }

    /** Makes a text of so many characters of the array, from a place on. */
    public String(char[] characters, int from, int count) {
        this(count);
        System.arraycopy(characters, from, this.characters, 0, count);
    }

    /** Makes a text of the numbers of so many characters, from a place on. */
    public String(int[] numbers, int from, int count) {
        int length = 0;
        for (int index = 0; index < count; index++) length += Character.charCount(numbers[from + index]);
        characters = new char[length];
        int place = 0;
        for (int index = from; index < from + count; index++) {
            place += Character.toChars(numbers[index], characters, place);
        }
    }

    /** Makes a text of bytes, each of which is a character from 0 to 255. */
    public String(byte[] bytes) {
        this(bytes, 0, bytes.length);
    }

    /** Makes a text of so many bytes, from a place on. */
    public String(byte[] bytes, int from, int count) {
        this(count);
        for (int index = 0; index < count; index++) characters[index] = (char) (bytes[from + index] & 0xFF);
    }

    /** Makes a text of bytes; how they are written does not matter. */
    public String(byte[] bytes, String charset) {
        this(bytes, 0, bytes.length);
    }

    /** Makes a text of so many bytes, from a place on; how they are written does not matter. */
    public String(byte[] bytes, int from, int count, String charset) {
        this(bytes, from, count);
    }

    /** Makes a text of bytes; the number counts 256 times in each character. */
    @Deprecated
    public String(byte[] bytes, int highByte) {
        this(bytes, highByte, 0, bytes.length);
    }

    /** Makes a text of so many bytes, from a place on; the number counts 256 times in each character. */
    @Deprecated
    public String(byte[] bytes, int highByte, int from, int count) {
        this(count);
        for (int index = 0; index < count; index++) {
            characters[index] = (char) (bytes[from + index] & 0xFF | highByte << 8);
        }
    }

    /** Makes a copy of a text. */
    public String(String text) {
        characters = text.characters;
    }

    /** Makes a text of what was put together. */
    public String(StringBuffer text) {
        this(text.toString());
    }

    /** Makes a text of what was put together. */
    public String(StringBuilder text) {
        this(text.toString());
    }

    private String(int length) {
        characters = new char[length];
    }

    /** Gives the value as text. */
    public static String valueOf(boolean value) {
        return value ? "true" : "false";
    }

    /** Gives the character as text. */
    public static String valueOf(char value) {
        String text = new String(1);
        text.characters[0] = value;
        return text;
    }

    /** Gives the number as text. */
    public static String valueOf(int value) {
        return Integer.toString(value, 10);
    }

    /** Gives the number as text. */
    public static String valueOf(long value) {
        return Long.toString(value, 10);
    }

    /** Gives the number as text. */
    public static String valueOf(float value) {
        return DecimalWriter.toString(value);
    }

    /** Gives the number as text. */
    public static String valueOf(double value) {
        return DecimalWriter.toString(value);
    }

    /** Gives the characters as text. */
    public static String valueOf(char[] characters) {
        return new String(characters);
    }

    /** Gives so many characters, from a place on, as text. */
    public static String valueOf(char[] characters, int from, int count) {
        return new String(characters, from, count);
    }

    /** Gives the object as text, and "null" for null. */
    public static String valueOf(Object object) {
        return object == null ? "null" : object.toString();
    }

    /** Gives the characters as text. */
    public static String copyValueOf(char[] characters) {
        return new String(characters);
    }

    /** Gives so many characters, from a place on, as text. */
    public static String copyValueOf(char[] characters, int from, int count) {
        return new String(characters, from, count);
    }

    /** Gives the number of characters. */
    public int length() {
        return characters.length;
    }

    /** Says whether there are no characters. */
    public boolean isEmpty() {
        return characters.length == 0;
    }

    /** Gives the character at a place; the first one is at place 0. */
    public char charAt(int index) {
        // Directly behind the text and before it, a brick fails with ArrayIndexOutOfBoundsException.
        if (index > characters.length) throw new StringIndexOutOfBoundsException(index);
        return characters[index];
    }

    /** Gives the number of the character at a place, also of one that needs a pair. */
    public int codePointAt(int index) {
        char high = charAt(index);
        if (index + 1 < characters.length && Character.isSurrogatePair(high, characters[index + 1])) {
            return Character.toCodePoint(high, characters[index + 1]);
        }
        return high;
    }

    /** Gives the characters as a new array. */
    public char[] toCharArray() {
        char[] copy = new char[characters.length];
        System.arraycopy(characters, 0, copy, 0, copy.length);
        return copy;
    }

    /** Copies the characters from one place up to, but not including, another into an array. */
    public void getChars(int start, int end, char[] target, int place) {
        check(start, end, characters.length);
        System.arraycopy(characters, start, target, place, end - start);
    }

    /** Gives the characters as bytes; what is above 255 is cut off. */
    public byte[] getBytes() {
        byte[] bytes = new byte[characters.length];
        for (int index = 0; index < bytes.length; index++) bytes[index] = (byte) characters[index];
        return bytes;
    }

    /** Gives the characters as bytes; how they are to be written does not matter. */
    public byte[] getBytes(String charset) {
        return getBytes();
    }

    /** Says whether both are the same text. */
    public boolean equals(Object other) {
        if (other == this) return true;
        return other instanceof String && isAt(0, ((String) other).characters, characters.length);
    }

    /** Says whether both are the same text, if small and large letters are alike. */
    public boolean equalsIgnoreCase(String other) {
        return toLowerCase().equals(other.toLowerCase());
    }

    /** Says whether the characters are the same. */
    public boolean contentEquals(CharSequence other) {
        if (other.length() != characters.length) return false;
        for (int index = 0; index < characters.length; index++) {
            if (other.charAt(index) != characters[index]) return false;
        }
        return true;
    }

    /** Says whether the characters are the same. */
    public boolean contentEquals(StringBuffer other) {
        return contentEquals((CharSequence) other);
    }

    /** Gives -1 if this text comes before the other one, 1 if it comes after it, and 0 if both are the same. */
    public int compareTo(String other) {
        int own = characters.length;
        int others = other.characters.length;
        for (int index = 0; index < own && index < others; index++) {
            if (characters[index] != other.characters[index]) {
                return characters[index] < other.characters[index] ? -1 : 1;
            }
        }
        return own == others ? 0 : own < others ? -1 : 1;
    }

    /** Gives a number that is the same for the same text. */
    public int hashCode() {
        int hash = 0;
        for (int index = 0; index < characters.length; index++) hash = 31 * hash + characters[index];
        return hash;
    }

    /** Says whether the text begins like this. */
    public boolean startsWith(String start) {
        return startsWith(start, 0);
    }

    /** Says whether the text goes on like this from a place on. */
    public boolean startsWith(String start, int from) {
        int count = start.characters.length;
        return from >= 0 && from <= characters.length - count && isAt(from, start.characters, from + count);
    }

    /**
     * Says whether the text ends like this.
     *
     * @hidden
     */
    public boolean endsWith(String end) {
        return startsWith(end, characters.length - end.characters.length);
    }

    /** Gives the first place of a character, or -1 if it is not there. */
    public int indexOf(int character) {
        return indexOf(character, 0);
    }

    /** Gives the first place of a character, looked for from a place on, or -1 if it is not there. */
    public int indexOf(int character, int from) {
        for (int index = from < 0 ? 0 : from; index < characters.length; index++) {
            if (characters[index] == character) return index;
        }
        return -1;
    }

    /** Gives the first place of a text, or -1 if it is not there. */
    public int indexOf(String text) {
        return indexOf(text, 0);
    }

    /** Gives the first place of a text, looked for from a place on, or -1 if it is not there. */
    public int indexOf(String text, int from) {
        return indexIn(characters, characters.length, text.characters, from);
    }

    /**
     * Gives the last place of a character, or -1 if it is not there.
     *
     * @hidden
     */
    public int lastIndexOf(int character) {
        return lastIndexOf(character, characters.length - 1);
    }

    /**
     * Gives the last place of a character up to a place, or -1 if it is not there.
     *
     * @hidden
     */
    public int lastIndexOf(int character, int from) {
        for (int index = from < characters.length ? from : characters.length - 1; index >= 0; index--) {
            if (characters[index] == character) return index;
        }
        return -1;
    }

    /** Gives the number of the character before a place, with the other half if it is the second one of a pair. */
    public int codePointBefore(int place) {
        return Character.codePointBefore(characters, place);
    }

    /** Gives how many characters there are from a place up to, but not including, another; a pair counts once. */
    public int codePointCount(int start, int end) {
        if (start < 0 || start > end || end > characters.length) throw new IndexOutOfBoundsException();
        int count = 0;
        for (int index = start; index < end; count++) {
            index += Character.charCount(Character.codePointAt(characters, index, end));
        }
        return count;
    }

    /** Gives the place so many characters further, or back if the number is below 0; a pair counts once. */
    public int offsetByCodePoints(int place, int count) {
        int offset = place;
        for (int left = count; left > 0; left--) offset += Character.charCount(codePointAt(offset));
        for (int left = count; left < 0; left++) offset -= Character.charCount(codePointBefore(offset));
        return offset;
    }

    /** Writes the characters from a place up to, but not including, another into an array as bytes. */
    @Deprecated
    public void getBytes(int start, int end, byte[] bytes, int place) {
        for (int index = start; index < end; index++) bytes[place + index - start] = (byte) characters[index];
    }

    /** Fails always: a brick makes each text anew. */
    public String intern() {
        throw new UnsupportedOperationException();
    }

    /** Gives the last place of a character, or -1 if it is not there. */
    public int lastIndexOf(char character) {
        return lastIndexOf((int) character);
    }

    /** Gives the last place of a character up to a place, or -1 if it is not there. */
    public int lastIndexOf(char character, int from) {
        return lastIndexOf((int) character, from);
    }

    /** Gives the last place of a text, or -1 if it is not there. */
    public int lastIndexOf(String text) {
        return lastIndexOf(text, characters.length);
    }

    /** Gives the last place of a text up to a place, or -1 if it is not there. */
    public int lastIndexOf(String text, int from) {
        return lastIndexIn(characters, characters.length, text.characters, from);
    }

    /** Gives the text from a place on. */
    public String substring(int start) {
        return substring(start, characters.length);
    }

    /** Gives the text from a place up to, but not including, another. */
    public String substring(int start, int end) {
        check(start, end, characters.length);
        return new String(characters, start, end - start);
    }

    /** Gives the text from a place up to, but not including, another. */
    public CharSequence subSequence(int start, int end) {
        return substring(start, end);
    }

    /**
     * Gives the other text if this one is empty, and otherwise fails with ArrayIndexOutOfBoundsException.
     *
     * <p>Join texts with + instead: leJOS NXJ has a mistake here.
     */
    public String concat(String other) {
        if (characters.length > 0) throw new ArrayIndexOutOfBoundsException();
        return new String(other.characters);
    }

    /** Gives the text with one character in the place of another. */
    public String replace(char old, char replacement) {
        String text = new String(characters);
        for (int index = 0; index < characters.length; index++) {
            if (characters[index] == old) text.characters[index] = replacement;
        }
        return text;
    }

    /** Gives the text in small letters; only A to Z are changed. */
    public String toLowerCase() {
        String text = new String(characters);
        for (int index = 0; index < characters.length; index++) {
            char character = characters[index];
            if (character >= 'A' && character <= 'Z') text.characters[index] = (char) (character + 'a' - 'A');
        }
        return text;
    }

    /** Gives the text in large letters; only a to z are changed. */
    public String toUpperCase() {
        String text = new String(characters);
        for (int index = 0; index < characters.length; index++) {
            char character = characters[index];
            if (character >= 'a' && character <= 'z') text.characters[index] = (char) (character - 'a' + 'A');
        }
        return text;
    }

    /** Gives the text without the blanks before and behind it. */
    public String trim() {
        int start = 0;
        int end = characters.length;
        while (start < end && characters[start] <= ' ') start++;
        while (end > start && characters[end - 1] <= ' ') end--;
        return end - start == characters.length ? this : new String(characters, start, end - start);
    }

    /** Gives the text itself. */
    public String toString() {
        return this;
    }

    static void check(int start, int end, int length) {
        if (start < 0) throw new StringIndexOutOfBoundsException(start);
        if (end > length) throw new StringIndexOutOfBoundsException(end);
        if (end < start) throw new StringIndexOutOfBoundsException(end - start);
    }

    /** The first place of the text in the first so many characters, not before a place; -1 if it is not there. */
    static int indexIn(char[] characters, int count, char[] text, int from) {
        int first = from < 0 ? 0 : from > count ? count : from;
        for (int index = first; index <= count - text.length; index++) {
            if (isAt(characters, index, text)) return index;
        }
        return -1;
    }

    /** The last place of the text in the first so many characters, not behind a place; -1 if it is not there. */
    static int lastIndexIn(char[] characters, int count, char[] text, int from) {
        for (int index = from < count - text.length ? from : count - text.length; index >= 0; index--) {
            if (isAt(characters, index, text)) return index;
        }
        return -1;
    }

    private static boolean isAt(char[] characters, int place, char[] text) {
        for (int index = 0; index < text.length; index++) {
            if (characters[place + index] != text[index]) return false;
        }
        return true;
    }

    /** Whether the text stands at the place and ends at the other one. */
    private boolean isAt(int place, char[] text, int end) {
        return end - place == text.length && isAt(characters, place, text);
    }
}
