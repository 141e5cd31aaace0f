package java.io;

/** Writes characters as bytes to a stream. */
public class OutputStreamWriter extends Writer {
    private final OutputStream out;
    private final boolean isUtf8;

    /** Makes one that writes to the stream; each character becomes a byte. */
    public OutputStreamWriter(OutputStream out) {
        this.out = out;
        isUtf8 = false;
    }

    /** Makes one that writes characters in a way such as "utf-8" or "iso-8859-1". */
    public OutputStreamWriter(OutputStream out, String charset) throws UnsupportedEncodingException {
        this.out = out;
        isUtf8 = Charsets.isUtf8(charset);
    }

    /** Writes a character. */
    public void write(int character) throws IOException {
        if (!isUtf8 || character < 0x80) {
            out.write(character);
        } else if (character < 0x800) {
            out.write(0xC0 | character >> 6);
            out.write(0x80 | character & 0x3F);
        } else {
            out.write(0xE0 | character >> 12);
            out.write(0x80 | character >> 6 & 0x3F);
            out.write(0x80 | character & 0x3F);
        }
    }

    /** Writes so many characters of the array, from a place on. */
    public void write(char[] characters, int offset, int length) throws IOException {
        for (int index = 0; index < length; index++) write(characters[offset + index]);
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
