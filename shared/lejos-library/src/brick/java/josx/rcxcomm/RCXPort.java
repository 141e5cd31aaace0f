package josx.rcxcomm;

import java.io.IOException;

/** Talks to another brick byte by byte. */
public class RCXPort extends RCXAbstractPort {
    /** Opens the port. */
    public RCXPort() throws IOException {
        super(new F7DeliveryHandler(new F7Handler()));
    }
}
