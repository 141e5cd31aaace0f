package josx.rcxcomm;

import java.io.IOException;

/** Talks to another brick with LEGO's messages, one byte each. */
public class RCXF7Port extends RCXAbstractPort {
    /** Opens the port. */
    public RCXF7Port() throws IOException {
        super(new F7DeliveryHandler(new F7Handler()));
    }
}
