package java.util;

/** A pile of objects: what is put on it last is taken off first. */
public class Stack extends Vector {
    /** Makes an empty pile. */
    public Stack() {
    }

    /** Puts an object on top and gives it back. */
    public Object push(Object element) {
        addElement(element);
        return element;
    }

    /** Takes the object on top off. */
    public synchronized Object pop() throws EmptyStackException {
        Object top = peek();
        removeElementAt(elementCount - 1);
        return top;
    }

    /** Gives the object on top, which stays there. */
    public synchronized Object peek() throws EmptyStackException {
        if (elementCount == 0) throw new EmptyStackException();
        return elementData[elementCount - 1];
    }

    /** Says whether nothing is on the pile. */
    public boolean empty() {
        return elementCount == 0;
    }

    /** Says how deep an object lies, 1 for the one on top, 2 for the one below, or -1 if it is not there. */
    public synchronized int search(Object element) {
        int place = lastIndexOf(element);
        return place < 0 ? -1 : elementCount - place;
    }
}
