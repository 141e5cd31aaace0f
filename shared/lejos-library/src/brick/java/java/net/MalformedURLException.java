package java.net;

import java.io.IOException;

/** A text is not the address of something on the internet. */
public class MalformedURLException extends IOException {
    /** Makes one without a message. */
    public MalformedURLException() {
    }
}
