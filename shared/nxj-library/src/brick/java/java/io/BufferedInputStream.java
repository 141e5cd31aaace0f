package java.io;

/** Reads many bytes at once from another stream. */
public class BufferedInputStream extends FilterInputStream {
    private final byte[] buffer;
    private int place;
    private int count;

    /** Makes one that reads from the stream. */
    public BufferedInputStream(InputStream in) {
        this(in, 64);
    }

    /** Makes one that reads so many bytes at once from the stream. */
    public BufferedInputStream(InputStream in, int size) {
        super(in);
        buffer = new byte[size];
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there are no more. */
    public synchronized int read() throws IOException {
        if (place >= count) {
            place = 0;
            count = in.read(buffer, 0, buffer.length);
            if (count <= 0) return -1;
        }
        return buffer[place++] & 0xFF;
    }

    /** Reads at most so many bytes into the array, from a place on, and gives how many, or -1 if there are no more. */
    public synchronized int read(byte[] bytes, int offset, int length) throws IOException {
        if (length == 0) return 0;
        int first = read();
        if (first < 0) return -1;
        bytes[offset] = (byte) first;
        int more = Math.min(length - 1, count - place);
        System.arraycopy(buffer, place, bytes, offset + 1, more);
        place += more;
        return more + 1;
    }

    /** Gives how many bytes can be read at once. */
    public synchronized int available() throws IOException {
        return Math.max(count - place, 0) + in.available();
    }
}
