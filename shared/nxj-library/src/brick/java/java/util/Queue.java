package java.util;

/** Elements that wait in a row: what came first goes first. On a brick, it is a class of its own: new Queue(). */
public class Queue<E> extends Vector<E> {
    /** Makes an empty queue. */
    public Queue() {
    }

    /** Puts an element at the end, and gives it. */
    public synchronized E push(E element) {
        addElement(element);
        return element;
    }

    /** Takes out the first element and gives it; fails with EmptyQueueException if there is none. */
    public synchronized E pop() {
        E first = peek();
        removeElementAt(0);
        return first;
    }

    /** Gives the first element; fails with EmptyQueueException if there is none. */
    public synchronized E peek() {
        if (isEmpty()) throw new EmptyQueueException();
        return elementAt(0);
    }

    /** Says whether there are no elements. */
    public synchronized boolean empty() {
        return isEmpty();
    }

    /**
     * Adds an element at the end.
     *
     * @hidden
     */
    public boolean offer(E element) {
        addElement(element);
        return true;
    }

    /**
     * Gives the first element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E element() {
        return firstElement();
    }

    /**
     * Takes out the first element and gives it; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public synchronized E remove() {
        E first = firstElement();
        removeElementAt(0);
        return first;
    }

    /**
     * Takes out the first element and gives it, or null if there is none.
     *
     * @hidden
     */
    public synchronized E poll() {
        return isEmpty() ? null : remove();
    }
}
