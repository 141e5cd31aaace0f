package josx.rcxcomm;

import java.io.IOException;
import java.io.InputStream;

/** The bytes that come to a port. */
class RCXInputStream extends InputStream {
    private static final int ROOM = 32;
    private static final int LOOK_MILLISECONDS = 10;

    private final RCXAbstractPort port;
    private final byte[] bytes = new byte[ROOM];
    private int first;
    private int count;

    RCXInputStream(RCXAbstractPort port) {
        this.port = port;
    }

    public int read() throws IOException {
        int began = (int) System.currentTimeMillis();
        while (count == 0) {
            int waited = (int) System.currentTimeMillis() - began;
            if (port.getTimeOut() != 0 && waited > port.getTimeOut()) throw new IOException("Nothing has come.");
            try {
                Thread.sleep(LOOK_MILLISECONDS);
            } catch (InterruptedException lookAgain) {
                // A byte may be there already.
            }
        }
        return take();
    }

    public int available() {
        return count;
    }

    /** A byte that finds no room is lost. */
    synchronized void add(byte value) {
        if (count == ROOM) return;
        bytes[first + count & ROOM - 1] = value;
        count++;
    }

    private synchronized int take() {
        int value = bytes[first] & 0xFF;
        first = first + 1 & ROOM - 1;
        count--;
        return value;
    }
}
