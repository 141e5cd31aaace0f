package javax.microedition.io;

import java.io.IOException;

/** Makes a connection when it is asked for one. */
public interface StreamConnectionNotifier extends Connection {
    /** Connects, and gives the connection; null if that fails. */
    StreamConnection acceptAndOpen() throws IOException;
}
