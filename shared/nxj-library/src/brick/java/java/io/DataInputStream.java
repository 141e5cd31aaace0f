package java.io;

/** Reads numbers and texts that a DataOutputStream has written. */
public class DataInputStream extends FilterInputStream implements DataInput {
    /** Makes one that reads from the stream. */
    public DataInputStream(InputStream in) {
        super(in);
    }

    /** Reads true or false. */
    public final boolean readBoolean() throws IOException {
        return readUnsignedByte() != 0;
    }

    /** Reads a byte. */
    public final byte readByte() throws IOException {
        return (byte) readUnsignedByte();
    }

    /** Reads a byte as a number from 0 to 255. */
    public final int readUnsignedByte() throws IOException {
        int read = in.read();
        if (read < 0) throw new EOFException();
        return read;
    }

    /** Reads a whole number of 16 bits. */
    public final short readShort() throws IOException {
        return (short) readUnsignedShort();
    }

    /** Reads two bytes as a number from 0 to 65535. */
    public final int readUnsignedShort() throws IOException {
        int high = readUnsignedByte();
        return high << 8 | readUnsignedByte();
    }

    /** Reads a character. */
    public final char readChar() throws IOException {
        return (char) readUnsignedShort();
    }

    /** Reads a whole number of 32 bits. */
    public final int readInt() throws IOException {
        int high = readUnsignedShort();
        return high << 16 | readUnsignedShort();
    }

    /** Reads a whole number of 64 bits. */
    public final long readLong() throws IOException {
        long high = readInt();
        return high << 32 | readInt() & 0xFFFFFFFFL;
    }

    /** Reads a number of 32 bits with a decimal point. */
    public final float readFloat() throws IOException {
        return Float.intBitsToFloat(readInt());
    }

    /** Reads a number of 64 bits with a decimal point. */
    public final double readDouble() throws IOException {
        return Double.longBitsToDouble(readLong());
    }

    /** Fills the array. */
    public final void readFully(byte[] bytes) throws IOException {
        readFully(bytes, 0, bytes.length);
    }

    /** Reads so many bytes into the array, from a place on. */
    public final void readFully(byte[] bytes, int offset, int length) throws IOException {
        int count = 0;
        while (count < length) {
            int read = in.read(bytes, offset + count, length - count);
            if (read < 0) throw new EOFException();
            count += read;
        }
    }

    /** Reads characters up to the end of the line, or null if there are no more. */
    public final String readLine() throws IOException {
        StringBuilder line = new StringBuilder();
        int read = in.read();
        if (read < 0) return null;
        while (read >= 0 && read != '\n') {
            if (read != '\r') line.append((char) read);
            read = in.read();
        }
        return line.toString();
    }

    /** Reads a text that writeUTF has written. */
    public final String readUTF() throws IOException {
        return readUTF(this);
    }

    /** Reads a text that writeUTF has written. */
    public static String readUTF(DataInput in) throws IOException {
        int left = in.readUnsignedShort();
        StringBuilder text = new StringBuilder(left);
        while (left > 0) {
            int first = in.readUnsignedByte();
            int more = first < 0x80 ? 0 : first < 0xE0 ? 1 : 2;
            int value = more == 0 ? first : more == 1 ? first & 0x1F : first & 0x0F;
            for (int index = 0; index < more; index++) value = value << 6 | in.readUnsignedByte() & 0x3F;
            text.append((char) value);
            left -= more + 1;
        }
        return text.toString();
    }

    /** Skips at most so many bytes, and gives how many. */
    public final int skipBytes(int count) throws IOException {
        return (int) in.skip(count);
    }
}
