package java.io;

/** Reads the bytes of an array. */
public class ByteArrayInputStream extends InputStream {
    /** The bytes. */
    protected byte[] buf;

    /** The place behind the last byte. */
    protected int count;

    /** The place to which reset goes back. */
    protected int mark;

    /** The place of the next byte. */
    protected int pos;

    /** Makes one of the whole array. */
    public ByteArrayInputStream(byte[] bytes) {
        this(bytes, 0, bytes.length);
    }

    /** Makes one of so many bytes, from a place on. */
    public ByteArrayInputStream(byte[] bytes, int offset, int length) {
        buf = bytes;
        pos = offset;
        mark = offset;
        count = Math.min(offset + length, bytes.length);
    }

    /** Gives the next byte, 0 to 255, or -1 if there are no more. */
    public synchronized int read() {
        return pos < count ? buf[pos++] & 0xFF : -1;
    }

    /** Gives how many bytes are left. */
    public synchronized int available() {
        return count - pos;
    }

    /** Remembers this place, for reset. */
    public void mark(int limit) {
        mark = pos;
    }

    /** Goes back to where mark was called. */
    public synchronized void reset() {
        pos = mark;
    }

    /** Says that mark and reset work. */
    public boolean markSupported() {
        return true;
    }
}
