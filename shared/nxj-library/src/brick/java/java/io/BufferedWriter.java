package java.io;

/** Writes many characters at once to another writer. */
public class BufferedWriter extends Writer {
    private static final int ROOM = 64;

    private final Writer out;
    private final char[] kept;
    private int count;

    /** Makes one that writes to the stream; better give it an OutputStreamWriter. */
    @Deprecated
    public BufferedWriter(OutputStream out) {
        this(new OutputStreamWriter(out));
    }

    /** Makes one that writes to the other one. */
    public BufferedWriter(Writer out) {
        this(out, ROOM);
    }

    /** Makes one that writes to the other one, and keeps so many characters back. */
    public BufferedWriter(Writer out, int size) {
        this.out = out;
        kept = new char[size < 1 ? 1 : size];
    }

    /** Writes a character. */
    public void write(int character) throws IOException {
        if (count == kept.length) empty();
        kept[count++] = (char) character;
    }

    /** Writes so many characters of the array, from a place on. */
    public void write(char[] characters, int offset, int length) throws IOException {
        for (int index = offset; index < offset + length; index++) write(characters[index]);
    }

    /** Writes so many characters of a text, from a place on. */
    public void write(String text, int offset, int length) throws IOException {
        append(text, offset, offset + length);
    }

    /** Writes the characters from a place up to, but not including, another, and gives this writer. */
    public Writer append(CharSequence text, int start, int end) throws IOException {
        for (int index = start; index < end; index++) write(text.charAt(index));
        return this;
    }

    /** Begins a new line: a brick writes both signs for it. */
    public void newLine() throws IOException {
        write('\r');
        write('\n');
    }

    /** Writes what was kept back. */
    public void flush() throws IOException {
        empty();
        out.flush();
    }

    /** Closes both. */
    public void close() throws IOException {
        try {
            empty();
        } finally {
            out.close();
        }
    }

    private void empty() throws IOException {
        if (count > 0) out.write(kept, 0, count);
        count = 0;
    }
}
