package josx.rcxcomm;

import java.io.IOException;

/** Would talk to bricks with LNP, which Robotran's brick does not know. */
public class RCXLNPPort extends RCXAbstractPort {
    /** Fails: this brick does not know LNP; use RCXPort. */
    public RCXLNPPort() throws IOException {
        super(noHandler());
    }

    private static PacketHandler noHandler() throws IOException {
        throw new IOException("This brick does not know LNP. Use RCXPort.");
    }
}
