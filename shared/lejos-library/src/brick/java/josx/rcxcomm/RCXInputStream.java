package josx.rcxcomm;

import java.io.IOException;
import java.io.InputStream;

/** The bytes that another brick sends with a port or an RCXOutputStream. */
public class RCXInputStream extends InputStream {
    /** For how many bytes there is room until they are read. */
    public static final int DEFAULT_BUFFER_SIZE = 32;

    /** For how many milliseconds reading waits unless setTimeOut is called: for ever. */
    public static final int DEFAULT_TIMEOUT = 0;

    private static final int LOOK_MILLISECONDS = 10;
    private static final int LONGEST_PACKET = 8;

    private final byte[] bytes = new byte[DEFAULT_BUFFER_SIZE];
    private int first;
    private int count;
    private int timeOut = DEFAULT_TIMEOUT;
    private boolean isOpen = true;

    /** Begins to receive. */
    public RCXInputStream() {
        this(new LLCReliableHandler(new LLCHandler()));
    }

    RCXInputStream(PacketHandler handler) {
        Receiver receiver = new Receiver(handler);
        receiver.setDaemon(true);
        receiver.start();
    }

    /** Sets for how many milliseconds reading waits; 0 are for ever. */
    public void setTimeOut(int milliseconds) {
        timeOut = milliseconds;
    }

    /** Waits for the next byte and gives it, 0 to 255; fails with IOException if none has come in time. */
    public int read() throws IOException {
        int began = (int) System.currentTimeMillis();
        while (count == 0) {
            int waited = (int) System.currentTimeMillis() - began;
            if (timeOut != 0 && waited > timeOut) throw new IOException("Nothing has come.");
            rest();
        }
        synchronized (bytes) {
            int value = bytes[first] & 0xFF;
            first = first + 1 & DEFAULT_BUFFER_SIZE - 1;
            count--;
            return value;
        }
    }

    /** Says how many bytes can be read without waiting. */
    public int available() throws IOException {
        return count;
    }

    /** Stops receiving. */
    public void close() {
        isOpen = false;
    }

    /** A byte that finds no room is lost. */
    private void add(byte value) {
        synchronized (bytes) {
            if (count == DEFAULT_BUFFER_SIZE) return;
            bytes[first + count & DEFAULT_BUFFER_SIZE - 1] = value;
            count++;
        }
    }

    private static void rest() {
        try {
            Thread.sleep(LOOK_MILLISECONDS);
        } catch (InterruptedException lookAgain) {
            // A byte may be there already.
        }
    }

    private class Receiver extends Thread {
        private final PacketHandler handler;
        private final byte[] packet = new byte[LONGEST_PACKET];

        Receiver(PacketHandler handler) {
            this.handler = handler;
        }

        public void run() {
            while (isOpen) {
                if (handler.isPacketAvailable()) {
                    int length = handler.receivePacket(packet);
                    for (int index = 0; index < length; index++) add(packet[index]);
                }
                rest();
            }
        }
    }
}
