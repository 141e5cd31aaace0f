package java.lang;

/** Has an order: two of a kind can be compared. */
public interface Comparable<T> {
    /** Gives a number below 0 if this one comes first, above 0 if the other one does, and 0 if neither does. */
    int compareTo(T other);
}
