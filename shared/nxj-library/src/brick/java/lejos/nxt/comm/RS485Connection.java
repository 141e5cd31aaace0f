package lejos.nxt.comm;

/** A connection between two robots by a cable from port 4 to port 4. */
public class RS485Connection extends LinkConnection {
    private boolean isFreed;

    RS485Connection(int link) {
        super(link);
    }

    /** Ends the connection. */
    public void close() {
        super.close();
        if (!isFreed) RS485.free();
        isFreed = true;
    }
}
