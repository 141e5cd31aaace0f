package java.io;

/** Reads from another stream. */
public class FilterInputStream extends InputStream {
    /** The other stream. */
    protected InputStream in;

    /** Makes one that reads from the stream. */
    protected FilterInputStream(InputStream in) {
        this.in = in;
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there are no more. */
    public int read() throws IOException {
        return in.read();
    }

    /** Reads at most so many bytes into the array, from a place on, and gives how many, or -1 if there are no more. */
    public int read(byte[] bytes, int offset, int length) throws IOException {
        return in.read(bytes, offset, length);
    }

    /** Gives how many bytes can be read at once. */
    public int available() throws IOException {
        return in.available();
    }

    /** Closes both. */
    public void close() throws IOException {
        in.close();
    }
}
