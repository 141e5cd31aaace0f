package java.io;

/** Reads the bytes of a stream as characters. */
public class InputStreamReader extends Reader {
    private final InputStream in;
    private final boolean isUtf8;

    /** Makes one that reads from the stream; each byte is a character. */
    public InputStreamReader(InputStream in) {
        this.in = in;
        isUtf8 = false;
    }

    /** Makes one that reads characters written in a way such as "utf-8" or "iso-8859-1". */
    public InputStreamReader(InputStream in, String charset) throws UnsupportedEncodingException {
        this.in = in;
        isUtf8 = Charsets.isUtf8(charset);
    }

    /** Waits for the next character and gives it, or -1 if there are no more. */
    public int read() throws IOException {
        int first = in.read();
        if (!isUtf8 || first < 0xC0) return first;
        int more = first < 0xE0 ? 1 : 2;
        int value = more == 1 ? first & 0x1F : first & 0x0F;
        for (int index = 0; index < more; index++) value = value << 6 | in.read() & 0x3F;
        return value;
    }

    /** Reads at most so many characters into the array, from a place on, and gives how many, or -1. */
    public int read(char[] characters, int offset, int length) throws IOException {
        for (int count = 0; count < length; count++) {
            int read = read();
            if (read < 0) return count == 0 ? -1 : count;
            characters[offset + count] = (char) read;
        }
        return length;
    }

    /** Says whether there is something to read at once. */
    public boolean ready() throws IOException {
        return in.available() > 0;
    }

    /** Closes both. */
    public void close() throws IOException {
        in.close();
    }
}
