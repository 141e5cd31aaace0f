package java.util;

/** Elements each of which is there only once. */
public interface Set<E> extends Collection<E> {
}
