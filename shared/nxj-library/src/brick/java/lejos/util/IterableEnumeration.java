package lejos.util;

import java.util.Enumeration;
import java.util.Iterator;

/** Makes a loop such as "for (String word : words)" possible for an Enumeration. */
public class IterableEnumeration<T> implements Iterable<T> {
    private final Enumeration<T> elements;

    /** Makes one for an Enumeration; only one loop can go through it. */
    public IterableEnumeration(Enumeration<T> en) {
        elements = en;
    }

    /** Gives what goes through the elements. */
    public Iterator<T> iterator() {
        return new Iterator<T>() {
            public boolean hasNext() {
                return elements.hasMoreElements();
            }

            public T next() {
                return elements.nextElement();
            }

            public void remove() {
                throw new UnsupportedOperationException();
            }
        };
    }
}
