package java.io;

/** Writes numbers as bytes, the highest byte first. */
public class DataOutputStream extends OutputStream {
    /** How many bytes were written. */
    protected int written;

    /** Where the bytes go to. */
    protected OutputStream out;

    /** Writes to the given stream. */
    public DataOutputStream(OutputStream out) {
        this.out = out;
    }

    /** Writes one byte: the last eight bits of the number. */
    public synchronized void write(int value) throws IOException {
        out.write(value);
        written++;
    }

    /** Writes a part of an array. */
    public synchronized void write(byte[] bytes, int first, int count) throws IOException {
        out.write(bytes, first, count);
        written += count;
    }

    /** Sends off what still waits to be written. */
    public void flush() throws IOException {
        out.flush();
    }

    /** Ends the writing. */
    public void close() throws IOException {
        out.close();
    }

    /** Writes true or false, one byte. */
    public final void writeBoolean(boolean value) throws IOException {
        write(value ? 1 : 0);
    }

    /** Writes a number from -128 to 127, one byte. */
    public final void writeByte(int value) throws IOException {
        write(value);
    }

    /** Writes a number from -32768 to 32767, two bytes. */
    public final void writeShort(int value) throws IOException {
        write(value >>> 8 & 0xFF);
        write(value & 0xFF);
    }

    /** Writes a character, two bytes. */
    public final void writeChar(int value) throws IOException {
        writeShort(value);
    }

    /** Writes a whole number, four bytes. */
    public final void writeInt(int value) throws IOException {
        writeShort(value >>> 16);
        writeShort(value);
    }

    /** Writes a decimal number, four bytes. */
    public final void writeFloat(float value) throws IOException {
        writeInt(Float.floatToIntBits(value));
    }

    /** Says how many bytes were written. */
    public final int size() {
        return written;
    }
}
