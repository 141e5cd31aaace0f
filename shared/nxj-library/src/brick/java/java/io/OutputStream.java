package java.io;

/** Takes bytes, one after the other. */
public abstract class OutputStream implements Closeable, Flushable {
    /** Makes one. */
    public OutputStream() {
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public abstract void write(int value) throws IOException;

    /** Writes all bytes of the array. */
    public void write(byte[] bytes) throws IOException {
        write(bytes, 0, bytes.length);
    }

    /** Writes so many bytes of the array, from a place on. */
    public void write(byte[] bytes, int offset, int length) throws IOException {
        for (int index = 0; index < length; index++) write(bytes[offset + index]);
    }

    /** Writes what was kept back. */
    public void flush() throws IOException {
    }

    /** Closes it. */
    public void close() throws IOException {
    }
}
