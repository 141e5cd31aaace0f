package java.io;

/** Characters that can be read one after the other. */
public abstract class Reader implements Closeable {
    /** Makes one. */
    protected Reader() {
    }

    /** Waits for the next character and gives it, or -1 if there are no more. */
    public int read() throws IOException {
        char[] one = new char[1];
        return read(one, 0, 1) < 0 ? -1 : one[0];
    }

    /** Reads characters into the array, and gives how many, or -1 if there are no more. */
    public int read(char[] characters) throws IOException {
        return read(characters, 0, characters.length);
    }

    /** Reads at most so many characters into the array, from a place on, and gives how many, or -1. */
    public abstract int read(char[] characters, int offset, int length) throws IOException;

    /** Skips at most so many characters, and gives how many. */
    public long skip(long count) throws IOException {
        if (count < 0) throw new IllegalArgumentException();
        long skipped = 0;
        while (skipped < count && read() >= 0) skipped++;
        return skipped;
    }

    /** Says whether mark and reset work; they do not. */
    public boolean markSupported() {
        return false;
    }

    /** Fails: this reader cannot go back. */
    public void mark(int limit) throws IOException {
        throw new IOException("mark not supported");
    }

    /** Fails: this reader cannot go back. */
    public void reset() throws IOException {
        throw new IOException("mark not supported");
    }

    /** Says whether there is something to read at once. */
    public boolean ready() throws IOException {
        return false;
    }

    /** Closes it. */
    public abstract void close() throws IOException;
}
