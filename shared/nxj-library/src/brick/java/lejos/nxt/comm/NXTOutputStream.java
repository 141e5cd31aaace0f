package lejos.nxt.comm;

import java.io.IOException;
import java.io.OutputStream;

/** Writes to a connection, when its buffer is full or flush is called. */
public class NXTOutputStream extends OutputStream {
    private final NXTConnection connection;
    private final byte[] buffer = new byte[128];
    private int count;

    NXTOutputStream(NXTConnection connection) {
        this.connection = connection;
    }

    /** Writes a byte: the lowest eight bits of the number. */
    public synchronized void write(int value) throws IOException {
        if (count == buffer.length) flush();
        buffer[count++] = (byte) value;
    }

    /** Sends what was written. */
    public synchronized void flush() throws IOException {
        if (count == 0) return;
        int sent = connection.write(buffer, count, true);
        count = 0;
        if (sent < 0) throw new IOException();
    }

    /** Sends what was written; the connection stays open. */
    public void close() throws IOException {
        flush();
    }
}
