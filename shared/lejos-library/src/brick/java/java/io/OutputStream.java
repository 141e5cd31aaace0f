package java.io;

/** Something that bytes go to, one after the other. */
public abstract class OutputStream {
    /** Makes one. */
    public OutputStream() {
    }

    /** Writes one byte: the last eight bits of the number. */
    public abstract void write(int value) throws IOException;

    /** Writes all bytes of an array. */
    public void write(byte[] bytes) throws IOException {
        write(bytes, 0, bytes.length);
    }

    /** Writes a part of an array. */
    public void write(byte[] bytes, int first, int count) throws IOException {
        for (int index = 0; index < count; index++) write(bytes[first + index]);
    }

    /** Sends off what still waits to be written. */
    public void flush() throws IOException {
    }

    /** Ends the writing. */
    public void close() throws IOException {
    }
}
