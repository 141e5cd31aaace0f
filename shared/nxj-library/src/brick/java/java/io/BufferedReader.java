package java.io;

/** Reads whole lines from another reader. */
public class BufferedReader extends Reader {
    private static final int NONE = -2;

    private final Reader in;

    /** A character that was read too early, or NONE. */
    private int next = NONE;

    /** Makes one that reads from the other one. */
    public BufferedReader(Reader in) {
        this.in = in;
    }

    /** Makes one that reads from the other one; the size does not matter. */
    public BufferedReader(Reader in, int size) {
        this(in);
    }

    /** Waits for the next character and gives it, or -1 if there are no more. */
    public int read() throws IOException {
        if (next == NONE) return in.read();
        int read = next;
        next = NONE;
        return read;
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

    /** Reads a line, without its end, or null if there are no more. */
    public String readLine() throws IOException {
        int read = read();
        if (read < 0) return null;
        StringBuilder line = new StringBuilder();
        while (read >= 0 && read != '\n' && read != '\r') {
            line.append((char) read);
            read = read();
        }
        if (read == '\r') {
            next = in.read();
            if (next == '\n') next = NONE;
        }
        return line.toString();
    }

    /** Says whether there is something to read at once. */
    public boolean ready() throws IOException {
        return next != NONE || in.ready();
    }

    /** Closes both. */
    public void close() throws IOException {
        in.close();
    }
}
