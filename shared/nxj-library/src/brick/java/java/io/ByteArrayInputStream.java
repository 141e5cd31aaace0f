package java.io;

/** Reads the bytes of an array. */
public class ByteArrayInputStream extends InputStream {
    private final byte[] bytes;
    private final int end;
    private int place;
    private int marked;

    /** Makes one of the whole array. */
    public ByteArrayInputStream(byte[] bytes) {
        this(bytes, 0, bytes.length);
    }

    /** Makes one of so many bytes, from a place on. */
    public ByteArrayInputStream(byte[] bytes, int offset, int length) {
        this.bytes = bytes;
        place = offset;
        marked = offset;
        end = Math.min(offset + length, bytes.length);
    }

    /** Gives the next byte, 0 to 255, or -1 if there are no more. */
    public synchronized int read() {
        return place < end ? bytes[place++] & 0xFF : -1;
    }

    /** Gives how many bytes are left. */
    public synchronized int available() {
        return end - place;
    }

    /** Remembers this place, for reset. */
    public void mark(int limit) {
        marked = place;
    }

    /** Goes back to where mark was called. */
    public synchronized void reset() {
        place = marked;
    }

    /** Says that mark and reset work. */
    public boolean markSupported() {
        return true;
    }
}
