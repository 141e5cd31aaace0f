package java.io;

/** Something that bytes come from, one after the other. */
public abstract class InputStream {
    /** Makes one. */
    public InputStream() {
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there are no more. */
    public abstract int read() throws IOException;

    /** Fills an array with bytes and says how many there were, or -1 if there are no more. */
    public int read(byte[] bytes) throws IOException {
        return read(bytes, 0, bytes.length);
    }

    /** Fills a part of an array with bytes and says how many there were, or -1 if there are no more. */
    public int read(byte[] bytes, int first, int count) throws IOException {
        int done = 0;
        while (done < count) {
            int next = read();
            if (next < 0) return done == 0 ? -1 : done;
            bytes[first + done] = (byte) next;
            done++;
        }
        return done;
    }

    /** Passes over so many bytes, or all if there are fewer, and says how many they were. */
    public long skip(long count) throws IOException {
        int wanted = (int) count;
        int skipped = 0;
        while (skipped < wanted && read() >= 0) skipped++;
        return skipped;
    }

    /** Says how many bytes can be read without waiting. */
    public int available() throws IOException {
        return 0;
    }

    /** Ends the reading. */
    public void close() throws IOException {
    }

    /** Marks a place to return to, unless the stream cannot do that. */
    public void mark(int limit) {
    }

    /** Returns to the marked place; fails if the stream cannot do that. */
    public void reset() throws IOException {
        throw new IOException("This stream cannot go back.");
    }

    /** Says whether the stream can return to a marked place. */
    public boolean markSupported() {
        return false;
    }
}
