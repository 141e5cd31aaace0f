package java.io;

/** Has to be closed when it is not needed any more. */
public interface Closeable extends AutoCloseable {
    /** Closes it. */
    void close() throws IOException;
}
