package java.io;

/** Writes to another stream. */
public class FilterOutputStream extends OutputStream {
    /** The other stream. */
    protected OutputStream out;

    /** Makes one that writes to the stream. */
    public FilterOutputStream(OutputStream out) {
        this.out = out;
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public void write(int value) throws IOException {
        out.write(value);
    }

    /** Writes so many bytes of the array, from a place on. */
    public void write(byte[] bytes, int offset, int length) throws IOException {
        for (int index = 0; index < length; index++) write(bytes[offset + index]);
    }

    /** Writes what was kept back. */
    public void flush() throws IOException {
        out.flush();
    }

    /** Closes both. */
    public void close() throws IOException {
        flush();
        out.close();
    }
}
