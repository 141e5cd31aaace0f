package java.util;

/** Elements in an order; the first one is at place 0. */
public interface List<E> extends Collection<E> {
    /** Gives the element at a place. */
    E get(int index);

    /** Puts an element in the place of another, which it gives. */
    E set(int index, E element);

    /** Puts an element at a place; those from there on move up. */
    void add(int index, E element);

    /** Adds an element at the end. */
    boolean add(E element);

    /** Puts all elements of the other collection at a place, and says whether there were any. */
    boolean addAll(int index, Collection<? extends E> others);

    /** Takes out the element at a place, and gives it; those behind it move down. */
    E remove(int index);

    /** Takes out the first such element, and says whether it was there. */
    boolean remove(Object element);

    /** Gives the first place of an element, or -1 if it is not there. */
    int indexOf(Object element);

    /** Gives the last place of an element, or -1 if it is not there. */
    int lastIndexOf(Object element);

    /** Gives what goes through the list in both directions. */
    ListIterator<E> listIterator();

    /** Gives what goes through the list in both directions, beginning at a place. */
    ListIterator<E> listIterator(int index);

    /** Is not possible on a brick. */
    List<E> subList(int start, int end);
}
