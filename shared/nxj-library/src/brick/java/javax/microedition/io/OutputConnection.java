package javax.microedition.io;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/** A connection to which bytes go. */
public interface OutputConnection extends Connection {
    /** Gives what writes to the connection. */
    OutputStream openOutputStream() throws IOException;

    /** Gives what writes numbers and texts to the connection. */
    DataOutputStream openDataOutputStream() throws IOException;
}
