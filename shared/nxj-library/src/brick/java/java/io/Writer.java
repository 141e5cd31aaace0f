package java.io;

/** Takes characters, one after the other. */
public abstract class Writer implements Closeable, Flushable {
    /** Makes one. */
    protected Writer() {
    }

    /** Writes a character. */
    public void write(int character) throws IOException {
        write(new char[] {(char) character}, 0, 1);
    }

    /** Writes all characters of the array. */
    public void write(char[] characters) throws IOException {
        write(characters, 0, characters.length);
    }

    /** Writes so many characters of the array, from a place on. */
    public abstract void write(char[] characters, int offset, int length) throws IOException;

    /** Writes a text. */
    public void write(String text) throws IOException {
        write(text.toCharArray());
    }

    /** Writes so many characters of a text, from a place on. */
    public void write(String text, int offset, int length) throws IOException {
        write(text.substring(offset, offset + length));
    }

    /** Writes a character, and gives this writer. */
    public Writer append(char character) throws IOException {
        write(character);
        return this;
    }

    /** Writes the characters, and gives this writer. */
    public Writer append(CharSequence text) throws IOException {
        return append(text, 0, text.length());
    }

    /** Writes the characters from a place up to, but not including, another, and gives this writer. */
    public Writer append(CharSequence text, int start, int end) throws IOException {
        for (int index = start; index < end; index++) write(text.charAt(index));
        return this;
    }

    /** Writes what was kept back. */
    public abstract void flush() throws IOException;

    /** Closes it. */
    public abstract void close() throws IOException;
}
