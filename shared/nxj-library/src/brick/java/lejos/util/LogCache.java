package lejos.util;

import java.io.OutputStream;

/** Keeps rows of bytes; when the memory is full, the oldest rows are lost. */
class LogCache extends OutputStream {
    private static final int FIRST_SIZE = 1024;
    private static final int MORE = 256;

    private byte[] bytes = new byte[FIRST_SIZE];
    private int first;
    private int count;
    private int rowLength;

    /** Says how many bytes a row has. */
    void setRowLength(int length) {
        rowLength = length;
    }

    public void write(int value) {
        if (count == bytes.length && !grows()) {
            first = (first + rowLength) % bytes.length;
            count -= rowLength;
        }
        bytes[(first + count) % bytes.length] = (byte) value;
        count++;
    }

    private boolean grows() {
        try {
            byte[] more = new byte[bytes.length + MORE];
            System.arraycopy(bytes, first, more, 0, bytes.length - first);
            System.arraycopy(bytes, 0, more, bytes.length - first, first);
            bytes = more;
            first = 0;
            return true;
        } catch (OutOfMemoryError noRoom) {
            return false;
        }
    }

    /** Takes the oldest bytes out, and gives them; null if there are not as many. */
    byte[] take(int length) {
        if (count < length) return null;
        byte[] taken = new byte[length];
        for (int i = 0; i < length; i++) taken[i] = bytes[(first + i) % bytes.length];
        first = (first + length) % bytes.length;
        count -= length;
        return taken;
    }
}
