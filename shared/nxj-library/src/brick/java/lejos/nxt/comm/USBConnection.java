package lejos.nxt.comm;

/** A connection to a computer by cable; here nobody has one. */
public class USBConnection extends NXTConnection {
    USBConnection() {
    }

    /** Reads nothing. */
    public int read(byte[] data, int len, boolean wait) {
        return -1;
    }

    /** Writes nothing. */
    public int write(byte[] data, int len, boolean wait) {
        return -1;
    }

    /** Gives that nothing can be read. */
    public int available(int what) {
        return -1;
    }

    /** Gives an empty text. */
    public String getAddress() {
        return "";
    }

    /** Ends the connection. */
    public void close() {
    }
}
