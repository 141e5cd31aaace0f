package java.net;

import java.io.IOException;

/** The address of something on the internet, which a brick in Robotran cannot reach. */
public class URL {
    private final String text;

    /** Makes one of its text. */
    public URL(String text) {
        this.text = text;
    }

    /** Fails: this brick has no network. */
    public URLConnection openConnection() throws IOException {
        throw new IOException("This brick has no network.");
    }

    /** Gives the address as text. */
    public String toString() {
        return text;
    }
}
