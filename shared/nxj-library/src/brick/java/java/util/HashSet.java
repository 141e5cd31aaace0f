package java.util;

/**
 * Elements each of which is there only once.
 *
 * <p>On a brick, nothing goes through them: a loop over a set fails with UnsupportedOperationException, and so does
 * what needs one. An element must not be null, and its hashCode must not be below 0, as it is for some texts: then the
 * brick fails with ArrayIndexOutOfBoundsException.
 */
public class HashSet<E> extends AbstractCollection<E> implements Set<E> {
    /** The elements by a number that is the same for the same element. */
    private final HashMap<Integer, LinkedList<E>> groups = new HashMap<Integer, LinkedList<E>>();

    private int count;

    /** Makes an empty set. */
    public HashSet() {
    }

    /**
     * Makes an empty set; the number does not matter.
     *
     * @hidden
     */
    public HashSet(int capacity) {
        if (capacity < 0) throw new IllegalArgumentException();
    }

    /**
     * Makes an empty set; the numbers do not matter.
     *
     * @hidden
     */
    public HashSet(int capacity, float loadFactor) {
        this(capacity);
    }

    /** Makes a set of the elements of another collection. */
    public HashSet(Collection<? extends E> others) {
        addAll(others);
    }

    /** Gives how many elements there are. */
    public int size() {
        return count;
    }

    /** Adds an element, and says whether it was not there before. */
    public boolean add(E element) {
        int number = numberOf(element);
        LinkedList<E> group = groups.get(number);
        if (group == null) {
            group = new LinkedList<E>();
            groups.put(number, group);
        } else if (group.contains(element)) {
            return false;
        }
        group.add(element);
        count++;
        return true;
    }

    /** Says whether the element is there. */
    public boolean contains(Object element) {
        LinkedList<E> group = groups.get(numberOf(element));
        return group != null && group.contains(element);
    }

    /** Takes out an element, and says whether it was there. */
    public boolean remove(Object element) {
        int number = numberOf(element);
        LinkedList<E> group = groups.get(number);
        if (group == null || !group.remove(element)) return false;
        if (group.isEmpty()) groups.remove(number);
        count--;
        return true;
    }

    /** Takes all elements out. */
    public void clear() {
        groups.clear();
        count = 0;
    }

    /** Fails with UnsupportedOperationException: keep the elements in a list of your own. */
    public Iterator<E> iterator() {
        throw new UnsupportedOperationException();
    }

    /** Says whether both are the very same set; fails if the other one is another HashSet of the same size. */
    public boolean equals(Object other) {
        if (other == this) return true;
        return other instanceof Set && ((Set<?>) other).size() == count && containsAll((Set<?>) other);
    }

    /** Fails with UnsupportedOperationException: a brick cannot go through the elements. */
    public int hashCode() {
        throw new UnsupportedOperationException();
    }

    private static int numberOf(Object element) {
        int number = element.hashCode();
        number ^= number >>> 20 ^ number >>> 12;
        return number ^ number >>> 7 ^ number >>> 4;
    }
}
