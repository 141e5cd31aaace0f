package javax.microedition.io;

import java.io.IOException;

/** A connection. */
public interface Connection {
    /** Ends the connection. */
    void close() throws IOException;
}
