package java.io;

/** Writes into an array, which grows as needed. */
public class ByteArrayOutputStream extends OutputStream {
    /** The bytes, with room behind them. */
    protected byte[] buf;

    /** How many bytes were written. */
    protected int count;

    /** Makes one. */
    public ByteArrayOutputStream() {
        this(32);
    }

    /** Makes one with room for so many bytes. */
    public ByteArrayOutputStream(int size) {
        buf = new byte[size];
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public synchronized void write(int value) {
        ensureCapacity(count + 1);
        buf[count++] = (byte) value;
    }

    /** Makes room for so many bytes. */
    public void ensureCapacity(int capacity) {
        if (capacity <= buf.length) return;
        byte[] larger = new byte[Math.max(capacity, 2 * buf.length)];
        System.arraycopy(buf, 0, larger, 0, count);
        buf = larger;
    }

    /** Gives how many bytes were written. */
    public int size() {
        return count;
    }

    /** Begins anew. */
    public synchronized void reset() {
        count = 0;
    }

    /** Gives what was written as a new array. */
    public synchronized byte[] toByteArray() {
        byte[] copy = new byte[count];
        System.arraycopy(buf, 0, copy, 0, count);
        return copy;
    }

    /** Writes all of it to another stream. */
    public synchronized void writeTo(OutputStream out) throws IOException {
        out.write(buf, 0, count);
    }

    /** Gives what was written as text. */
    public String toString() {
        return new String(buf, 0, count);
    }

    /** Gives what was written as text; the number counts 256 times in each character. */
    @Deprecated
    public String toString(int highByte) {
        return new String(buf, highByte, 0, count);
    }

    /** Gives what was written as text; how it is written does not matter. */
    public String toString(String charset) throws UnsupportedEncodingException {
        return new String(buf, 0, count, charset);
    }
}
