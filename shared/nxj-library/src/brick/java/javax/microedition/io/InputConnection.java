package javax.microedition.io;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;

/** A connection from which bytes come. */
public interface InputConnection extends Connection {
    /** Gives what reads from the connection. */
    InputStream openInputStream() throws IOException;

    /** Gives what reads numbers and texts from the connection. */
    DataInputStream openDataInputStream() throws IOException;
}
