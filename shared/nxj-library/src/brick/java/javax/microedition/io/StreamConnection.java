package javax.microedition.io;

/** A connection for both directions, such as a BTConnection. */
public interface StreamConnection extends InputConnection, OutputConnection {
}
