package java.io;

/** Reads numbers and texts that a DataOutput has written. */
public interface DataInput {
    /** Reads true or false. */
    boolean readBoolean() throws IOException;

    /** Reads a byte. */
    byte readByte() throws IOException;

    /** Reads a character. */
    char readChar() throws IOException;

    /** Reads a number of 64 bits with a decimal point. */
    double readDouble() throws IOException;

    /** Reads a number of 32 bits with a decimal point. */
    float readFloat() throws IOException;

    /** Fills the array. */
    void readFully(byte[] bytes) throws IOException;

    /** Reads so many bytes into the array, from a place on. */
    void readFully(byte[] bytes, int offset, int length) throws IOException;

    /** Reads a whole number of 32 bits. */
    int readInt() throws IOException;

    /** Reads characters up to the end of the line, or null if there are no more. */
    String readLine() throws IOException;

    /** Reads a whole number of 64 bits. */
    long readLong() throws IOException;

    /** Reads a whole number of 16 bits. */
    short readShort() throws IOException;

    /** Reads a byte as a number from 0 to 255. */
    int readUnsignedByte() throws IOException;

    /** Reads two bytes as a number from 0 to 65535. */
    int readUnsignedShort() throws IOException;

    /** Reads a text. */
    String readUTF() throws IOException;

    /** Skips at most so many bytes, and gives how many. */
    int skipBytes(int count) throws IOException;
}
