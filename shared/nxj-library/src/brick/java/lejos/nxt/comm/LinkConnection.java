package lejos.nxt.comm;

import lejos.util.Delay;

/** A connection between two robots that the machine knows by a number. */
abstract class LinkConnection extends NXTConnection {
    private static final int PERIOD = 5;
    private static final int LONGEST_NAME = 16;

    private final int link;
    private final byte[] buffer = new byte[256];
    private int place;
    private int count;
    private boolean isClosed;

    LinkConnection(int link) {
        this.link = link;
    }

    /** Reads bytes into the array, and says whether to wait if there are none; gives how many, or below 0. */
    public int read(byte[] data, int len, boolean wait) {
        while (!isClosed) {
            int arrived = available();
            if (arrived != 0 || !wait || len == 0) return arrived < 0 ? arrived : take(data, len);
            Delay.msDelay(PERIOD);
        }
        return -1;
    }

    /** Writes bytes of the array, and says whether to wait until there is room; gives how many, or below 0. */
    public int write(byte[] data, int len, boolean wait) {
        int written = 0;
        while (!isClosed) {
            int taken = BTLink.write(link, data, written, len - written);
            if (taken < 0) return taken;
            written += taken;
            if (written == len || !wait) return written;
            Delay.msDelay(PERIOD);
        }
        return -1;
    }

    /** Gives how many bytes can be read at once, or below 0 if there will be none. */
    public synchronized int available(int what) {
        if (place < count) return count - place;
        if (isClosed) return -1;
        place = 0;
        count = 0;
        int arrived = BTLink.read(link, buffer, 0, buffer.length);
        if (arrived > 0) count = arrived;
        return arrived;
    }

    /** Gives the name of the other robot. */
    public String getAddress() {
        byte[] name = new byte[LONGEST_NAME];
        return new String(name, 0, BTLink.partner(link, name));
    }

    /** Ends the connection. */
    public void close() {
        if (isClosed) return;
        isClosed = true;
        BTLink.close(link);
    }

    private synchronized int take(byte[] data, int len) {
        int taken = Math.min(len, count - place);
        System.arraycopy(buffer, place, data, 0, taken);
        place += taken;
        return taken;
    }
}
