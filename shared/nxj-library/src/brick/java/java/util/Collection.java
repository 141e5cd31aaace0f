package java.util;

/** A number of elements, such as a list or a set. */
public interface Collection<E> extends Iterable<E> {
    /** Gives how many elements there are. */
    int size();

    /** Says whether there are no elements. */
    boolean isEmpty();

    /** Says whether the element is there. */
    boolean contains(Object element);

    /** Says whether all elements of the other collection are there. */
    boolean containsAll(Collection<?> others);

    /** Adds an element, and says whether that changed anything. */
    boolean add(E element);

    /** Adds all elements of the other collection, and says whether that changed anything. */
    boolean addAll(Collection<? extends E> others);

    /** Takes out one such element, and says whether it was there. */
    boolean remove(Object element);

    /** Takes out all elements that are also in the other collection, and says whether that changed anything. */
    boolean removeAll(Collection<?> others);

    /** Takes out all elements that are not in the other collection, and says whether that changed anything. */
    boolean retainAll(Collection<?> others);

    /** Takes all elements out. */
    void clear();

    /** Gives the elements as a new array. */
    Object[] toArray();

    /** Gives the elements in the array, which must have room for them. */
    <T> T[] toArray(T[] array);
}
