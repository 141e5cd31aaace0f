package java.io;

/** Reads the bytes of a stream as characters. */
public class InputStreamReader extends Reader {
    private final InputStream in;

    /** Makes one that reads from the stream. */
    public InputStreamReader(InputStream in) {
        this.in = in;
    }

    /** Waits for the next character and gives it, or -1 if there are no more. */
    public int read() throws IOException {
        return in.read();
    }

    /** Reads at most so many characters into the array, from a place on, and gives how many, or -1. */
    public int read(char[] characters, int offset, int length) throws IOException {
        for (int count = 0; count < length; count++) {
            int read = in.read();
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
