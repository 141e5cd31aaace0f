package josx.rcxcomm;

import java.io.IOException;
import java.io.OutputStream;

/** The bytes that a port sends. */
class RCXOutputStream extends OutputStream {
    private final PacketHandler handler;
    private final byte[] packet = new byte[1];

    RCXOutputStream(PacketHandler handler) {
        this.handler = handler;
    }

    public synchronized void write(int value) throws IOException {
        packet[0] = (byte) value;
        if (!handler.sendPacket(packet, 1)) throw new IOException("Nobody has answered.");
    }
}
