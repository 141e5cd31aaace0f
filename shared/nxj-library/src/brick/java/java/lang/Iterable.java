package java.lang;

import java.util.Iterator;

/** Has elements through which a for loop can go. */
public interface Iterable<T> {
    /** Gives what goes through the elements. */
    Iterator<T> iterator();
}
