package lejos.nxt.comm;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.InputStream;
import java.io.OutputStream;
import javax.microedition.io.StreamConnection;

/** A connection between two robots, over which both send bytes. */
public abstract class NXTConnection implements StreamConnection {
    /** Bytes go in packets. */
    public static final int PACKET = 0;

    /** Bytes go in packets of LEGO's own form. */
    public static final int LCP = 1;

    /** Bytes go one by one. */
    public static final int RAW = 2;

    /** Makes one. */
    protected NXTConnection() {
    }

    /** Reads bytes into the array, waits if there are none, and gives how many, or below 0 if there will be none. */
    public int read(byte[] data, int len) {
        return read(data, len, true);
    }

    /** Reads bytes into the array, and says whether to wait if there are none; gives how many, or below 0. */
    public abstract int read(byte[] data, int len, boolean wait);

    /** Writes bytes of the array, waits until there is room, and gives how many, or below 0 if nobody is there. */
    public int write(byte[] data, int len) {
        return write(data, len, true);
    }

    /** Writes bytes of the array, and says whether to wait until there is room; gives how many, or below 0. */
    public abstract int write(byte[] data, int len, boolean wait);

    /** Reads a packet if there is one, and gives how many bytes it has; 0 if there is none. */
    public int readPacket(byte[] buf, int len) {
        return read(buf, len, false);
    }

    /** Sends a packet if there is room, and gives how many bytes it has; 0 if there is none. */
    public int sendPacket(byte[] buf, int bufLen) {
        return write(buf, bufLen, false);
    }

    /** Gives how many bytes can be read at once, or below 0 if there will be none. */
    public int available() {
        return available(0);
    }

    /** Gives how many bytes can be read at once, or below 0 if there will be none; all packets count, whatever is asked. */
    public abstract int available(int what);

    /** Gives the name of the other robot. */
    public abstract String getAddress();

    /** Sets how bytes go: PACKET, LCP or RAW. Both robots see the same bytes whichever it is. */
    public void setIOMode(int mode) {
    }

    /** Ends the connection. */
    public abstract void close();

    /** Gives what reads from the connection. */
    public InputStream openInputStream() {
        return new NXTInputStream(this);
    }

    /** Gives what writes to the connection, once flush is called. */
    public OutputStream openOutputStream() {
        return new NXTOutputStream(this);
    }

    /** Gives what reads numbers and texts from the connection. */
    public DataInputStream openDataInputStream() {
        return new DataInputStream(openInputStream());
    }

    /** Gives what writes numbers and texts to the connection, once flush is called. */
    public DataOutputStream openDataOutputStream() {
        return new DataOutputStream(openOutputStream());
    }
}
