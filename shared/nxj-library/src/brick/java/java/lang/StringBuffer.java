package java.lang;

/** Puts a text together, piece by piece; several threads can do so at a time. */
public final class StringBuffer implements CharSequence {
    private char[] characters;
    private int count;

    /** Makes an empty one. */
    public StringBuffer() {
        this(10);
    }

    /** Makes an empty one with room for so many characters; it grows as needed. */
    public StringBuffer(int capacity) {
        if (capacity < 0) throw new NegativeArraySizeException();
        characters = new char[capacity];
    }

    /** Makes one that begins with the text. */
    public StringBuffer(String text) {
        characters = text.toCharArray();
        count = characters.length;
    }

    /** Makes one that begins with the characters. */
    public StringBuffer(CharSequence text) {
        this(text.toString());
    }

    /** Puts the value at the end. */
    public synchronized StringBuffer append(boolean value) {
        return append(String.valueOf(value));
    }

    /** Puts the character at the end. */
    public synchronized StringBuffer append(char value) {
        ensureCapacity(count + 1);
        characters[count++] = value;
        return this;
    }

    /** Puts the number at the end. */
    public synchronized StringBuffer append(int value) {
        return append(String.valueOf(value));
    }

    /** Puts the number at the end. */
    public synchronized StringBuffer append(long value) {
        return append(String.valueOf(value));
    }

    /** Puts the number at the end. */
    public synchronized StringBuffer append(float value) {
        return append(String.valueOf(value));
    }

    /** Puts the number at the end. */
    public synchronized StringBuffer append(double value) {
        return append(String.valueOf(value));
    }

    /** Puts the object, as text, at the end. */
    public synchronized StringBuffer append(Object object) {
        return append(String.valueOf(object));
    }

    /** Puts the text at the end. */
    public synchronized StringBuffer append(String text) {
        char[] added = text == null ? "null".characters : text.characters;
        return append(added, 0, added.length);
    }

    /** Puts the characters at the end. */
    public synchronized StringBuffer append(char[] characters) {
        return append(characters, 0, characters.length);
    }

    /** Puts so many characters, from a place on, at the end. */
    public synchronized StringBuffer append(char[] characters, int from, int count) {
        ensureCapacity(this.count + count);
        System.arraycopy(characters, from, this.characters, this.count, count);
        this.count += count;
        return this;
    }

    /** Puts the characters at the end. */
    public synchronized StringBuffer append(CharSequence text) {
        return append(String.valueOf(text));
    }

    /** Puts the characters from a place up to, but not including, another at the end. */
    public synchronized StringBuffer append(CharSequence text, int start, int end) {
        ensureCapacity(count + end - start);
        for (int index = start; index < end; index++) characters[count++] = text.charAt(index);
        return this;
    }

    /** Puts what another one has put together at the end. */
    public synchronized StringBuffer append(StringBuffer text) {
        return append(String.valueOf(text));
    }

    /** Puts the character with this number, or its pair, at the end. */
    public synchronized StringBuffer appendCodePoint(int number) {
        return append(Character.toChars(number));
    }

    /** Takes out the character at a place. */
    public synchronized StringBuffer deleteCharAt(int index) {
        if (index < 0 || index >= count) throw new StringIndexOutOfBoundsException(index);
        return delete(index, index + 1);
    }

    /** Takes out the characters from a place up to, but not including, another. */
    public synchronized StringBuffer delete(int start, int end) {
        int last = end > count ? count : end;
        String.check(start, last, count);
        System.arraycopy(characters, last, characters, start, count - last);
        count -= last - start;
        return this;
    }

    /** Gives the number of characters. */
    public synchronized int length() {
        return count;
    }

    /** Cuts off what is behind so many characters, or adds characters 0. */
    public synchronized void setLength(int length) {
        if (length < 0) throw new IndexOutOfBoundsException();
        ensureCapacity(length);
        while (count < length) characters[count++] = 0;
        count = length;
    }

    /** Makes room for so many characters. */
    public synchronized void ensureCapacity(int capacity) {
        int larger = characters.length;
        if (capacity <= larger) return;
        while (larger < capacity) larger = larger * 3 / 2 + 1;
        resize(larger);
    }

    /** Gives for how many characters there is room. */
    public synchronized int capacity() {
        return characters.length;
    }

    /** Gives up the room behind the last character. */
    public synchronized void trimToSize() {
        if (count < characters.length) resize(count);
    }

    /** Gives the character at a place; the first one is at place 0. */
    public synchronized char charAt(int index) {
        if (index < 0 || index >= count) throw new StringIndexOutOfBoundsException(index);
        return characters[index];
    }

    /** Puts a character in the place of another. */
    public synchronized void setCharAt(int index, char value) {
        if (index < 0 || index >= count) throw new StringIndexOutOfBoundsException(index);
        characters[index] = value;
    }

    /** Copies the characters from one place up to, but not including, another into an array. */
    public synchronized void getChars(int start, int end, char[] target, int place) {
        String.check(start, end, count);
        System.arraycopy(characters, start, target, place, end - start);
    }

    /** Gives the first place of a text, or -1 if it is not there. */
    public synchronized int indexOf(String text) {
        return indexOf(text, 0);
    }

    /** Gives the first place of a text, looked for from a place on, or -1 if it is not there. */
    public synchronized int indexOf(String text, int from) {
        return String.indexIn(characters, count, text.characters, from);
    }

    /** Gives the last place of a text, or -1 if it is not there. */
    public synchronized int lastIndexOf(String text) {
        return lastIndexOf(text, count);
    }

    /** Gives the last place of a text up to a place, or -1 if it is not there. */
    public synchronized int lastIndexOf(String text, int from) {
        return String.lastIndexIn(characters, count, text.characters, from);
    }

    /** Gives the text from a place on. */
    public synchronized String substring(int start) {
        return substring(start, count);
    }

    /** Gives the text from a place up to, but not including, another. */
    public synchronized String substring(int start, int end) {
        String.check(start, end, count);
        return new String(characters, start, end - start);
    }

    /** Gives the text from a place up to, but not including, another. */
    public synchronized CharSequence subSequence(int start, int end) {
        return substring(start, end);
    }

    /** Gives what was put together. */
    public synchronized String toString() {
        return new String(characters, 0, count);
    }

    private void resize(int capacity) {
        char[] copy = new char[capacity];
        System.arraycopy(characters, 0, copy, 0, count);
        characters = copy;
    }
}
