package java.util;

/** What all sets can do. */
public abstract class AbstractSet<E> extends AbstractCollection<E> implements Set<E> {
    /** Makes one. */
    protected AbstractSet() {
    }

    /** Says whether the other one is a set with the same elements. */
    public boolean equals(Object other) {
        if (other == this) return true;
        return other instanceof Set && ((Set<?>) other).size() == size() && containsAll((Set<?>) other);
    }

    /** Gives a number that is the same for the same elements. */
    public int hashCode() {
        int hash = 0;
        for (E element : this) hash += element == null ? 0 : element.hashCode();
        return hash;
    }
}
