package java.lang;

/** Has to be closed when it is not needed any more. */
public interface AutoCloseable {
    /** Closes it. */
    void close() throws Exception;
}
