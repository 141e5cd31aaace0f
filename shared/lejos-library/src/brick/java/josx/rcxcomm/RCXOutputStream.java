package josx.rcxcomm;

import java.io.IOException;
import java.io.OutputStream;

/** Sends bytes to another brick, which reads them with a port or an RCXInputStream. */
public class RCXOutputStream extends OutputStream {
    private final PacketHandler handler;
    private final byte[] packet = new byte[1];

    /** Begins to send. */
    public RCXOutputStream() {
        this(new LLCReliableHandler(new LLCHandler()));
    }

    RCXOutputStream(PacketHandler handler) {
        this.handler = handler;
    }

    /** Sends one byte, the last eight bits of the number, again and again until the other brick has answered. */
    public synchronized void write(int value) throws IOException {
        packet[0] = (byte) value;
        if (!handler.sendPacket(packet, 1)) throw new IOException("Nobody has answered.");
    }
}
