package java.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Would talk to a computer on the internet, which a brick in Robotran cannot reach. */
public class Socket {
    /** Fails: this brick has no network. */
    public Socket(String host, int port) throws IOException {
        throw new IOException("This brick has no network.");
    }

    /** Gives nothing: no socket can be made. */
    public InputStream getInputStream() {
        return null;
    }

    /** Gives nothing: no socket can be made. */
    public OutputStream getOutputStream() {
        return null;
    }

    /** Does nothing: no socket can be made. */
    public void close() throws IOException {
    }
}
