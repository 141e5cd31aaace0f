package lejos.nxt.comm;

import lejos.util.Delay;

/** A Bluetooth connection between two robots. */
public class BTConnection extends NXTConnection {
    private static final int PERIOD = 5;

    private final int link;
    private boolean isClosed;

    BTConnection(int link) {
        this.link = link;
    }

    /** Reads bytes into the array, and says whether to wait if there are none; gives how many, or below 0. */
    public int read(byte[] data, int len, boolean wait) {
        while (!isClosed) {
            int count = Bluetooth.readLink(link, data, 0, len);
            if (count != 0 || !wait || len == 0) return count;
            Delay.msDelay(PERIOD);
        }
        return -1;
    }

    /** Writes bytes of the array, and says whether to wait until there is room; gives how many, or below 0. */
    public int write(byte[] data, int len, boolean wait) {
        int written = 0;
        while (!isClosed) {
            int count = Bluetooth.writeLink(link, data, written, len - written);
            if (count < 0) return count;
            written += count;
            if (written == len || !wait) return written;
            Delay.msDelay(PERIOD);
        }
        return -1;
    }

    /** Gives how many bytes can be read at once. */
    public int available() {
        return isClosed ? -1 : Bluetooth.availableOfLink(link);
    }

    /** Ends the connection. */
    public void close() {
        if (isClosed) return;
        isClosed = true;
        Bluetooth.closeLink(link);
    }
}
