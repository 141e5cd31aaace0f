package java.io;

/** Writes numbers and texts for a DataInputStream; call flush when a message is complete. */
public class DataOutputStream extends FilterOutputStream implements DataOutput {
    /** How many bytes were written. */
    protected int written;

    /** Makes one that writes to the stream. */
    public DataOutputStream(OutputStream out) {
        super(out);
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public void write(int value) throws IOException {
        out.write(value);
        written++;
    }

    /** Writes so many bytes of the array, from a place on. */
    public void write(byte[] bytes, int offset, int length) throws IOException {
        out.write(bytes, offset, length);
        written += length;
    }

    /** Writes true or false. */
    public final void writeBoolean(boolean value) throws IOException {
        write(value ? 1 : 0);
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public final void writeByte(int value) throws IOException {
        write(value);
    }

    /** Writes the lowest 16 bits of the number. */
    public final void writeShort(int value) throws IOException {
        write(value >> 8);
        write(value);
    }

    /** Writes a character. */
    public final void writeChar(int value) throws IOException {
        writeShort(value);
    }

    /** Writes a whole number of 32 bits. */
    public final void writeInt(int value) throws IOException {
        writeShort(value >> 16);
        writeShort(value);
    }

    /** Writes a whole number of 64 bits. */
    public final void writeLong(long value) throws IOException {
        writeInt((int) (value >> 32));
        writeInt((int) value);
    }

    /** Writes a number of 32 bits with a decimal point. */
    public final void writeFloat(float value) throws IOException {
        writeInt(Float.floatToIntBits(value));
    }

    /** Writes a number of 64 bits with a decimal point. */
    public final void writeDouble(double value) throws IOException {
        writeLong(Double.doubleToLongBits(value));
    }

    /** Writes the characters as bytes. */
    public final void writeBytes(String text) throws IOException {
        for (int index = 0; index < text.length(); index++) write(text.charAt(index));
    }

    /** Writes the characters, two bytes for each. */
    public final void writeChars(String text) throws IOException {
        for (int index = 0; index < text.length(); index++) writeShort(text.charAt(index));
    }

    /** Writes a text: its length in two bytes, and then up to three bytes for each character. */
    public final void writeUTF(String text) throws IOException {
        int length = 0;
        for (int index = 0; index < text.length(); index++) length += sizeOf(text.charAt(index));
        if (length > 0xFFFF) throw new UTFDataFormatException();
        writeShort(length);
        for (int index = 0; index < text.length(); index++) {
            char character = text.charAt(index);
            int size = sizeOf(character);
            if (size == 1) {
                write(character);
            } else {
                write(size == 2 ? 0xC0 | character >> 6 : 0xE0 | character >> 12);
                if (size == 3) write(0x80 | character >> 6 & 0x3F);
                write(0x80 | character & 0x3F);
            }
        }
    }

    /** Gives how many bytes were written. */
    public final int size() {
        return written;
    }

    private static int sizeOf(char character) {
        return character != 0 && character < 0x80 ? 1 : character < 0x800 ? 2 : 3;
    }
}
