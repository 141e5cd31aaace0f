package java.io;

/** May keep back what is written to it until flush is called. */
public interface Flushable {
    /** Writes what was kept back. */
    void flush() throws IOException;
}
