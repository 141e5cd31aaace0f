package javax.microedition.io;

import java.io.IOException;

/** There is no such kind of connection. */
public class ConnectionNotFoundException extends IOException {
    /** Makes one without a text. */
    public ConnectionNotFoundException() {
    }

    /** Makes one with a text. */
    public ConnectionNotFoundException(String s) {
        super(s);
    }
}
