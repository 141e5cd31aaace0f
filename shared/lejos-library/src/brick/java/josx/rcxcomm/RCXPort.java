package josx.rcxcomm;

import java.io.IOException;

/** Talks to another brick byte by byte; each byte is sent until the other brick has answered. */
public class RCXPort extends RCXAbstractPort {
    /** Opens the port. */
    public RCXPort() throws IOException {
        super(new LLCReliableHandler(new LLCHandler()));
    }
}
