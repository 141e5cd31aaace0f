package java.io;

/** Writes characters as bytes to a stream. */
public class OutputStreamWriter extends Writer {
    private final OutputStream out;

    /** Makes one that writes to the stream. */
    public OutputStreamWriter(OutputStream out) {
        this.out = out;
    }

    /** Writes a character. */
    public void write(int character) throws IOException {
        out.write(character);
    }

    /** Writes so many characters of the array, from a place on. */
    public void write(char[] characters, int offset, int length) throws IOException {
        for (int index = 0; index < length; index++) out.write(characters[offset + index]);
    }

    /** Writes what was kept back. */
    public void flush() throws IOException {
        out.flush();
    }

    /** Closes both. */
    public void close() throws IOException {
        flush();
        out.close();
    }
}
