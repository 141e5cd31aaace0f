package java.util;

/** Elements that wait in a row: what came first goes first. */
public interface Queue<E> extends Collection<E> {
    /** Adds an element at the end. */
    boolean offer(E element);

    /** Gives the first element; fails with NoSuchElementException if there is none. */
    E element();

    /** Gives the first element, or null if there is none. */
    E peek();

    /** Takes out the first element and gives it; fails with NoSuchElementException if there is none. */
    E remove();

    /** Takes out the first element and gives it, or null if there is none. */
    E poll();
}
