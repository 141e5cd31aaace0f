package java.io;

/** Writes into an array, which grows as needed. */
public class ByteArrayOutputStream extends OutputStream {
    private byte[] bytes;
    private int count;

    /** Makes one. */
    public ByteArrayOutputStream() {
        this(32);
    }

    /** Makes one with room for so many bytes. */
    public ByteArrayOutputStream(int size) {
        bytes = new byte[size];
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public synchronized void write(int value) {
        if (count == bytes.length) {
            byte[] larger = new byte[2 * count + 8];
            System.arraycopy(bytes, 0, larger, 0, count);
            bytes = larger;
        }
        bytes[count++] = (byte) value;
    }

    /** Gives how many bytes were written. */
    public int size() {
        return count;
    }

    /** Begins anew. */
    public synchronized void reset() {
        count = 0;
    }

    /** Gives what was written as a new array. */
    public synchronized byte[] toByteArray() {
        byte[] copy = new byte[count];
        System.arraycopy(bytes, 0, copy, 0, count);
        return copy;
    }

    /** Writes all of it to another stream. */
    public synchronized void writeTo(OutputStream out) throws IOException {
        out.write(bytes, 0, count);
    }

    /** Gives what was written as text. */
    public String toString() {
        return new String(bytes, 0, count);
    }
}
