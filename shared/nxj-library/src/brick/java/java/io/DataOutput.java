package java.io;

/** Writes numbers and texts for a DataInput. */
public interface DataOutput {
    /** Writes a byte: the lowest eight bits of the number. */
    void write(int value) throws IOException;

    /**
     * Writes all bytes of the array.
     *
     * @hidden
     */
    void write(byte[] bytes) throws IOException;

    /** Writes so many bytes of the array, from a place on. */
    void write(byte[] bytes, int offset, int length) throws IOException;

    /** Writes true or false. */
    void writeBoolean(boolean value) throws IOException;

    /** Writes a byte: the lowest eight bits of the number. */
    void writeByte(int value) throws IOException;

    /** Writes the characters as bytes. */
    void writeBytes(String text) throws IOException;

    /** Writes a character. */
    void writeChar(int value) throws IOException;

    /** Writes the characters, two bytes for each. */
    void writeChars(String text) throws IOException;

    /** Writes a number of 64 bits with a decimal point. */
    void writeDouble(double value) throws IOException;

    /** Writes a number of 32 bits with a decimal point. */
    void writeFloat(float value) throws IOException;

    /** Writes a whole number of 32 bits. */
    void writeInt(int value) throws IOException;

    /** Writes a whole number of 64 bits. */
    void writeLong(long value) throws IOException;

    /** Writes the lowest 16 bits of the number. */
    void writeShort(int value) throws IOException;

    /** Writes a text. */
    void writeUTF(String text) throws IOException;
}
