package java.io;

/** Reads numbers that a DataOutputStream has written. */
public class DataInputStream extends InputStream {
    /** Where the bytes come from. */
    protected InputStream in;

    /** Reads from the given stream. */
    public DataInputStream(InputStream in) {
        this.in = in;
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there are no more. */
    public int read() throws IOException {
        return in.read();
    }

    /** Says how many bytes can be read without waiting. */
    public int available() throws IOException {
        return in.available();
    }

    /** Ends the reading. */
    public void close() throws IOException {
        in.close();
    }

    /** Reads true or false, one byte. */
    public final boolean readBoolean() throws IOException {
        return next() != 0;
    }

    /** Reads a number from -128 to 127, one byte. */
    public final byte readByte() throws IOException {
        return (byte) next();
    }

    /** Reads a number from -32768 to 32767, two bytes. */
    public final short readShort() throws IOException {
        int high = next() << 8;
        return (short) (high | next());
    }

    /** Reads a character, two bytes. */
    public final char readChar() throws IOException {
        int high = next() << 8;
        return (char) (high | next());
    }

    /** Reads a whole number, four bytes. */
    public final int readInt() throws IOException {
        int high = readShort() << 16;
        return high | readShort() & 0xFFFF;
    }

    /** Reads a decimal number, four bytes. */
    public final float readFloat() throws IOException {
        return Float.intBitsToFloat(readInt());
    }

    private int next() throws IOException {
        int value = in.read();
        if (value < 0) throw new IOException("There are no more bytes.");
        return value;
    }
}
