package josx.rcxcomm;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** A way to talk to another brick byte by byte. */
public abstract class RCXAbstractPort {
    /** Sends and receives the packets. */
    protected PacketHandler packetHandler;

    private final RCXInputStream input;
    private final RCXOutputStream output;
    private int timeOut;

    /** Opens a port on top of a handler. */
    public RCXAbstractPort(PacketHandler handler) throws IOException {
        packetHandler = handler;
        input = new RCXInputStream(handler);
        output = new RCXOutputStream(handler);
    }

    /** Gives what the other brick's bytes are read from. */
    public InputStream getInputStream() {
        return input;
    }

    /** Gives what bytes for the other brick are written to. */
    public OutputStream getOutputStream() {
        return output;
    }

    /** Begins to count the packets anew. */
    public void reset() {
        packetHandler.reset();
    }

    /** Stops receiving. */
    public void close() {
        input.close();
    }

    /** Gives for how many milliseconds reading waits; 0 are for ever. */
    public int getTimeOut() {
        return timeOut;
    }

    /** Sets for how many milliseconds reading waits; 0 are for ever. */
    public void setTimeOut(int milliseconds) {
        timeOut = milliseconds;
        input.setTimeOut(milliseconds);
    }
}
