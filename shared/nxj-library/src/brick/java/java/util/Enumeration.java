package java.util;

/** Goes through elements one by one, as older classes do it. */
public interface Enumeration<E> {
    /** Says whether there is a further element. */
    boolean hasMoreElements();

    /** Gives the next element; fails with NoSuchElementException if there is none. */
    E nextElement();
}
