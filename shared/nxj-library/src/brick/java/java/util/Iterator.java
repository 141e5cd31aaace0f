package java.util;

/** Goes through elements one by one. */
public interface Iterator<E> {
    /** Says whether there is a further element. */
    boolean hasNext();

    /** Gives the next element; fails with NoSuchElementException if there is none. */
    E next();

    /** Takes out the element that next has given. */
    void remove();
}
