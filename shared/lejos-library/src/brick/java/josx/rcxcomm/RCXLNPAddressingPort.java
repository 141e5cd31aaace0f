package josx.rcxcomm;

import java.io.IOException;

/** Would talk to one of several bricks with LNP, which Robotran's brick does not know. */
public class RCXLNPAddressingPort extends RCXAbstractPort {
    /** Fails: this brick does not know LNP; use RCXPort. */
    public RCXLNPAddressingPort(byte source, byte destination) throws IOException {
        super(noHandler());
    }

    private static PacketHandler noHandler() throws IOException {
        throw new IOException("This brick does not know LNP. Use RCXPort.");
    }
}
