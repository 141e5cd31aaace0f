package java.util;

/** What all collections can do once they have an iterator and a size. */
public abstract class AbstractCollection<E> implements Collection<E> {
    /** Makes one. */
    protected AbstractCollection() {
    }

    /** Fails, unless the class knows better. */
    public boolean add(E element) {
        throw new UnsupportedOperationException();
    }

    /** Adds all elements of the other collection, and says whether that changed anything. */
    public boolean addAll(Collection<? extends E> others) {
        boolean hasChanged = false;
        for (E element : others) {
            if (add(element)) hasChanged = true;
        }
        return hasChanged;
    }

    /** Takes all elements out. */
    public void clear() {
        for (Iterator<E> elements = iterator(); elements.hasNext();) {
            elements.next();
            elements.remove();
        }
    }

    /** Says whether the element is there. */
    public boolean contains(Object element) {
        for (E own : this) {
            if (isSame(element, own)) return true;
        }
        return false;
    }

    /** Says whether all elements of the other collection are there. */
    public boolean containsAll(Collection<?> others) {
        for (Object element : others) {
            if (!contains(element)) return false;
        }
        return true;
    }

    /** Says whether there are no elements. */
    public boolean isEmpty() {
        return size() == 0;
    }

    /** Takes out one such element, and says whether it was there. */
    public boolean remove(Object element) {
        for (Iterator<E> elements = iterator(); elements.hasNext();) {
            if (isSame(element, elements.next())) {
                elements.remove();
                return true;
            }
        }
        return false;
    }

    /** Takes out all elements that are also in the other collection, and says whether that changed anything. */
    public boolean removeAll(Collection<?> others) {
        return removeIf(others, true);
    }

    /** Takes out all elements that are not in the other collection, and says whether that changed anything. */
    public boolean retainAll(Collection<?> others) {
        return removeIf(others, false);
    }

    /** Gives the elements as a new array. */
    public Object[] toArray() {
        return toArray(new Object[size()]);
    }

    /** Gives the elements in the array, which must have room for them; behind them stands null. */
    @SuppressWarnings("unchecked")
    public <T> T[] toArray(T[] array) {
        int place = 0;
        for (E element : this) array[place++] = (T) element;
        if (place < array.length) array[place] = null;
        return array;
    }

    /** Gives all elements as text. */
    public String toString() {
        StringBuilder text = new StringBuilder("[");
        for (E element : this) {
            if (text.length() > 1) text.append(", ");
            text.append(element == this ? "(this Collection)" : (Object) element);
        }
        return text.append(']').toString();
    }

    static boolean isSame(Object wanted, Object element) {
        return wanted == null ? element == null : wanted.equals(element);
    }

    private boolean removeIf(Collection<?> others, boolean isThere) {
        boolean hasChanged = false;
        for (Iterator<E> elements = iterator(); elements.hasNext();) {
            if (others.contains(elements.next()) == isThere) {
                elements.remove();
                hasChanged = true;
            }
        }
        return hasChanged;
    }
}
