package java.util;

/** Goes through a list in both directions. */
public interface ListIterator<E> extends Iterator<E> {
    /** Says whether there is an element before. */
    boolean hasPrevious();

    /** Gives the element before; fails with NoSuchElementException if there is none. */
    E previous();

    /** Gives the place of the element that next would give. */
    int nextIndex();

    /** Gives the place of the element that previous would give. */
    int previousIndex();

    /** Puts an element in the place of the one that next or previous has given. */
    void set(E element);

    /** Puts an element before the one that next would give. */
    void add(E element);
}
