package java.io;

/** Bytes that can be read one after the other. */
public abstract class InputStream implements Closeable {
    /** Makes one. */
    public InputStream() {
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there are no more. */
    public abstract int read() throws IOException;

    /** Reads bytes into the array, and gives how many, or -1 if there are no more. */
    public int read(byte[] bytes) throws IOException {
        return read(bytes, 0, bytes.length);
    }

    /** Reads at most so many bytes into the array, from a place on, and gives how many, or -1 if there are no more. */
    public int read(byte[] bytes, int offset, int length) throws IOException {
        for (int count = 0; count < length; count++) {
            int read = read();
            if (read < 0) return count == 0 ? -1 : count;
            bytes[offset + count] = (byte) read;
        }
        return length;
    }

    /** Skips at most so many bytes, and gives how many. */
    public long skip(long count) throws IOException {
        long skipped = 0;
        while (skipped < count && read() >= 0) skipped++;
        return skipped;
    }

    /** Gives how many bytes can be read at once. */
    public int available() throws IOException {
        return 0;
    }

    /** Closes it. */
    public void close() throws IOException {
    }

    /** Remembers this place, for reset. */
    public void mark(int limit) {
    }

    /** Goes back to where mark was called. */
    public void reset() throws IOException {
        throw new IOException();
    }

    /** Says whether mark and reset work. */
    public boolean markSupported() {
        return false;
    }
}
