package java.util;

/** A queue of objects: who came first is the first to leave. */
public class Queue extends Vector {
    /** Makes an empty queue. */
    public Queue() {
    }

    /** Puts an object at the end and gives it back. */
    public Object push(Object element) {
        addElement(element);
        return element;
    }

    /** Takes the first object out. */
    public synchronized Object pop() throws EmptyQueueException {
        Object first = peek();
        removeElementAt(0);
        return first;
    }

    /** Gives the first object, which stays there. */
    public synchronized Object peek() throws EmptyQueueException {
        if (elementCount == 0) throw new EmptyQueueException();
        return elementData[0];
    }

    /** Says whether nobody is in the queue. */
    public boolean empty() {
        return elementCount == 0;
    }
}
