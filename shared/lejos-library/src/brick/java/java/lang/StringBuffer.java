package java.lang;

/** A text that can grow and shrink. */
public final class StringBuffer {
    private char[] characters;
    private int count;

    /** Makes an empty text. */
    public StringBuffer() {
        characters = new char[16];
    }

    /** Makes an empty text with room for so many characters; it grows if there are more. */
    public StringBuffer(int room) {
        characters = new char[room];
    }

    /** Makes a text that begins as a copy of another. */
    public StringBuffer(String text) {
        characters = new char[text.length() + 16];
        append(text);
    }

    /** Puts a text at the end. */
    public StringBuffer append(String text) {
        return append(text == null ? "null".characters : text.characters);
    }

    /** Puts an object's text at the end. */
    public StringBuffer append(Object object) {
        return append(String.valueOf(object));
    }

    /** Puts true or false at the end. */
    public StringBuffer append(boolean value) {
        return append(value ? "true" : "false");
    }

    /** Puts a character at the end. */
    public StringBuffer append(char character) {
        makeRoom(1);
        characters[count++] = character;
        return this;
    }

    /** Puts a whole number at the end. */
    public StringBuffer append(int number) {
        return append(StringUtils.getCharacters(number));
    }

    /** Puts a whole number at the end; a brick's long has only 32 bits. */
    public StringBuffer append(long number) {
        return append((int) number);
    }

    /** Puts a decimal number at the end. */
    public StringBuffer append(float number) {
        return append(StringUtils.getCharacters(number));
    }

    /** Puts a decimal number at the end; a brick's double has only 32 bits. */
    public StringBuffer append(double number) {
        return append((float) number);
    }

    /** Takes away the characters from one place up to another, which stays. */
    public StringBuffer delete(int first, int end) {
        int last = end > count ? count : end;
        if (first < 0 || first > last) throw new ArrayIndexOutOfBoundsException();
        for (int place = last; place < count; place++) characters[place - last + first] = characters[place];
        count -= last - first;
        return this;
    }

    /** Gives the character at a place; the first one is at place 0. */
    public char charAt(int place) {
        if (place >= count) throw new ArrayIndexOutOfBoundsException();
        return characters[place];
    }

    /** Says how many characters there are. */
    public int length() {
        return count;
    }

    /** Gives all characters as a new array. */
    public char[] getChars() {
        char[] copy = new char[count];
        System.arraycopy(characters, 0, copy, 0, count);
        return copy;
    }

    /** Gives the text as it is now. */
    public String toString() {
        return new String(characters, 0, count);
    }

    private StringBuffer append(char[] text) {
        makeRoom(text.length);
        System.arraycopy(text, 0, characters, count, text.length);
        count += text.length;
        return this;
    }

    private void makeRoom(int more) {
        if (count + more <= characters.length) return;
        char[] larger = new char[count + more + 16];
        System.arraycopy(characters, 0, larger, 0, count);
        characters = larger;
    }
}
