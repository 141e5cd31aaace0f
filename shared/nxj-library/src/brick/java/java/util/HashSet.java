package java.util;

/** Elements each of which is there only once, in no particular order. */
public class HashSet<E> extends AbstractSet<E> {
    private final HashMap<E, Object> elements;

    /** Makes an empty set. */
    public HashSet() {
        elements = new HashMap<E, Object>();
    }

    /** Makes an empty set with room for so many elements; it grows as needed. */
    public HashSet(int capacity) {
        elements = new HashMap<E, Object>(capacity);
    }

    /** Makes an empty set with room for so many elements, which grows when this part of it is used. */
    public HashSet(int capacity, float loadFactor) {
        elements = new HashMap<E, Object>(capacity, loadFactor);
    }

    /** Makes a set of the elements of another collection. */
    public HashSet(Collection<? extends E> others) {
        this(2 * others.size());
        addAll(others);
    }

    /** Gives how many elements there are. */
    public int size() {
        return elements.size();
    }

    /** Adds an element, and says whether it was not there before. */
    public boolean add(E element) {
        if (elements.containsKey(element)) return false;
        elements.put(element, null);
        return true;
    }

    /** Says whether the element is there. */
    public boolean contains(Object element) {
        return elements.containsKey(element);
    }

    /** Takes out an element, and says whether it was there. */
    public boolean remove(Object element) {
        if (!elements.containsKey(element)) return false;
        elements.remove(element);
        return true;
    }

    /** Takes all elements out. */
    public void clear() {
        elements.clear();
    }

    /** Gives what goes through the set. */
    public Iterator<E> iterator() {
        return elements.keySet().iterator();
    }
}
