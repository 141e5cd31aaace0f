package java.net;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Would read something on the internet, which a brick in Robotran cannot reach. */
public abstract class URLConnection {
    private URLConnection() {
    }

    /** Fails: this brick has no network. */
    public abstract InputStream getInputStream() throws IOException;

    /** Fails: this brick has no network. */
    public abstract OutputStream getOutputStream() throws IOException;
}
