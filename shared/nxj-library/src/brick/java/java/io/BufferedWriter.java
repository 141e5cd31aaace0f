package java.io;

/** Writes many characters at once to another writer. */
public class BufferedWriter extends Writer {
    private final Writer out;
    private final StringBuilder buffer = new StringBuilder();

    /** Makes one that writes to the other one. */
    public BufferedWriter(Writer out) {
        this.out = out;
    }

    /** Makes one that writes to the other one; the size does not matter. */
    public BufferedWriter(Writer out, int size) {
        this(out);
    }

    /** Writes so many characters of the array, from a place on. */
    public void write(char[] characters, int offset, int length) throws IOException {
        buffer.append(characters, offset, length);
        if (buffer.length() >= 64) empty();
    }

    /** Begins a new line. */
    public void newLine() throws IOException {
        write('\n');
    }

    /** Writes what was kept back. */
    public void flush() throws IOException {
        empty();
        out.flush();
    }

    /** Closes both. */
    public void close() throws IOException {
        flush();
        out.close();
    }

    private void empty() throws IOException {
        out.write(buffer.toString());
        buffer.setLength(0);
    }
}
