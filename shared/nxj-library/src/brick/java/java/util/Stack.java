package java.util;

/** A stack of elements: what was put there last is taken first. */
public class Stack<E> extends Vector<E> {
    /** Makes an empty stack. */
    public Stack() {
    }

    /** Puts an element on top, and gives it. */
    public E push(E element) {
        addElement(element);
        return element;
    }

    /** Takes the element from the top, and gives it; fails with EmptyStackException if there is none. */
    public synchronized E pop() {
        E top = peek();
        removeElementAt(size() - 1);
        return top;
    }

    /** Gives the element on top; fails with EmptyStackException if there is none. */
    public synchronized E peek() {
        if (isEmpty()) throw new EmptyStackException();
        return elementAt(size() - 1);
    }

    /** Says whether there are no elements. */
    public boolean empty() {
        return isEmpty();
    }

    /** Gives how deep an element is, 1 for the top, or -1 if it is not there. */
    public synchronized int search(Object element) {
        int index = lastIndexOf(element);
        return index < 0 ? -1 : size() - index;
    }
}
