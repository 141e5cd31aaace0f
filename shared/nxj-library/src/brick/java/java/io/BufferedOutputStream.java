package java.io;

/** Writes many bytes at once to another stream. */
public class BufferedOutputStream extends FilterOutputStream {
    private final byte[] buffer;
    private int count;

    /** Makes one that writes to the stream. */
    public BufferedOutputStream(OutputStream out) {
        this(out, 64);
    }

    /** Makes one that writes so many bytes at once to the stream. */
    public BufferedOutputStream(OutputStream out, int size) {
        super(out);
        buffer = new byte[size];
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public synchronized void write(int value) throws IOException {
        if (count == buffer.length) empty();
        buffer[count++] = (byte) value;
    }

    /** Writes so many bytes of the array, from a place on. */
    public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
        for (int index = 0; index < length; index++) write(bytes[offset + index]);
    }

    /** Writes what was kept back. */
    public synchronized void flush() throws IOException {
        empty();
        out.flush();
    }

    private void empty() throws IOException {
        out.write(buffer, 0, count);
        count = 0;
    }
}
