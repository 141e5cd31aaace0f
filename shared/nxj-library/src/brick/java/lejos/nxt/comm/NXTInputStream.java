package lejos.nxt.comm;

import java.io.IOException;
import java.io.InputStream;

/** Reads from a connection. */
public class NXTInputStream extends InputStream {
    private final NXTConnection connection;
    private final byte[] buffer = new byte[128];
    private int place;
    private int count;

    NXTInputStream(NXTConnection connection) {
        this.connection = connection;
    }

    /** Waits for the next byte and gives it, 0 to 255, or -1 if there will be none. */
    public synchronized int read() throws IOException {
        while (place >= count) {
            place = 0;
            count = connection.read(buffer, buffer.length, true);
            if (count < 0) return -1;
        }
        return buffer[place++] & 0xFF;
    }

    /** Waits for bytes, reads at most so many into the array, from a place on, and gives how many, or -1. */
    public synchronized int read(byte[] bytes, int offset, int length) throws IOException {
        if (length == 0) return 0;
        int first = read();
        if (first < 0) return -1;
        bytes[offset] = (byte) first;
        int more = Math.min(length - 1, count - place);
        System.arraycopy(buffer, place, bytes, offset + 1, more);
        place += more;
        return more + 1;
    }

    /** Gives how many bytes can be read at once. */
    public synchronized int available() throws IOException {
        return Math.max(0, count - place) + Math.max(0, connection.available());
    }

    /** Closes it, and not the connection. */
    public void close() throws IOException {
    }
}
