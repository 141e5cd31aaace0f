package josx.rcxcomm;

import java.io.IOException;

/** Talks to all bricks in sight with LNP, the protocol of brickOS; bytes can get lost. */
public class RCXLNPPort extends RCXAbstractPort {
    /** Opens the port. */
    public RCXLNPPort() throws IOException {
        super(new LNPIntegrityHandler(new LNPHandler(), (byte) 0xF0));
    }
}
