package java.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Would read something on the internet, which a brick in Robotran cannot reach. */
public class URLConnection {
    private final Socket socket;

    /** Asks a computer for what is at a path; fails, because this brick has no network. */
    public URLConnection(String host, int port, String path) throws IOException {
        socket = new Socket(host, port);
    }

    /** Gives what is read: nothing, since no connection can be made. */
    public InputStream getInputStream() {
        return socket.getInputStream();
    }

    /** Gives what can be written to: nothing, since no connection can be made. */
    public OutputStream getOutputStream() {
        return socket.getOutputStream();
    }
}
