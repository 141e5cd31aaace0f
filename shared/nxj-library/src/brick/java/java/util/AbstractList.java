package java.util;

/** What all lists can do once they have a size and give the element at a place. */
public abstract class AbstractList<E> extends AbstractCollection<E> implements List<E> {
    /** How many times elements have come or gone; whoever goes through the list notices it. */
    protected int modCount;

    /** Makes one. */
    protected AbstractList() {
    }

    /** Adds an element at the end. */
    public boolean add(E element) {
        add(size(), element);
        return true;
    }

    /** Fails, unless the class knows better. */
    public void add(int index, E element) {
        throw new UnsupportedOperationException();
    }

    /** Puts all elements of the other collection at a place, and says whether there were any. */
    public boolean addAll(int index, Collection<? extends E> others) {
        if (index < 0 || index > size()) throw new IndexOutOfBoundsException();
        int place = index;
        for (E element : others) add(place++, element);
        return place > index;
    }

    /** Takes all elements out. */
    public void clear() {
        removeRange(0, size());
    }

    /** Says whether the other one is a list with the same elements in the same order. */
    public boolean equals(Object other) {
        if (other == this) return true;
        if (!(other instanceof List)) return false;
        Iterator<?> own = iterator();
        Iterator<?> others = ((List<?>) other).iterator();
        while (own.hasNext() && others.hasNext()) {
            if (!isSame(own.next(), others.next())) return false;
        }
        return !own.hasNext() && !others.hasNext();
    }

    /** Gives a number that is the same for the same elements in the same order. */
    public int hashCode() {
        int hash = 1;
        for (E element : this) hash = 31 * hash + (element == null ? 0 : element.hashCode());
        return hash;
    }

    /** Gives the first place of an element, or -1 if it is not there. */
    public int indexOf(Object element) {
        for (ListIterator<E> elements = listIterator(); elements.hasNext();) {
            if (isSame(element, elements.next())) return elements.previousIndex();
        }
        return -1;
    }

    /** Gives the last place of an element, or -1 if it is not there. */
    public int lastIndexOf(Object element) {
        for (ListIterator<E> elements = listIterator(size()); elements.hasPrevious();) {
            if (isSame(element, elements.previous())) return elements.nextIndex();
        }
        return -1;
    }

    /** Gives what goes through the list. */
    public Iterator<E> iterator() {
        return listIterator(0);
    }

    /** Gives what goes through the list in both directions. */
    public ListIterator<E> listIterator() {
        return listIterator(0);
    }

    /** Gives what goes through the list in both directions, beginning at a place. */
    public ListIterator<E> listIterator(int index) {
        if (index < 0 || index > size()) throw new IndexOutOfBoundsException();
        return new Elements(index);
    }

    /** Fails, unless the class knows better. */
    public E remove(int index) {
        throw new UnsupportedOperationException();
    }

    /** Takes out the elements from a place up to, but not including, another. */
    protected void removeRange(int start, int end) {
        for (int index = end - 1; index >= start; index--) remove(index);
    }

    /** Fails, unless the class knows better. */
    public E set(int index, E element) {
        throw new UnsupportedOperationException();
    }

    /** Fails always: a brick cannot do it. */
    public List<E> subList(int start, int end) {
        throw new UnsupportedOperationException();
    }

    private class Elements implements ListIterator<E> {
        private int next;
        private int given = -1;
        private int expectedModCount = modCount;

        Elements(int next) {
            this.next = next;
        }

        public boolean hasNext() {
            return next < size();
        }

        public boolean hasPrevious() {
            return next > 0;
        }

        public int nextIndex() {
            return next;
        }

        public int previousIndex() {
            return next - 1;
        }

        public E next() {
            check(hasNext());
            given = next++;
            return get(given);
        }

        public E previous() {
            check(hasPrevious());
            given = --next;
            return get(given);
        }

        public void remove() {
            checkGiven();
            AbstractList.this.remove(given);
            if (given < next) next--;
            given = -1;
            expectedModCount = modCount;
        }

        public void set(E element) {
            checkGiven();
            AbstractList.this.set(given, element);
        }

        public void add(E element) {
            check(true);
            AbstractList.this.add(next++, element);
            given = -1;
            expectedModCount = modCount;
        }

        private void check(boolean isThere) {
            if (expectedModCount != modCount) throw new ConcurrentModificationException();
            if (!isThere) throw new NoSuchElementException();
        }

        private void checkGiven() {
            if (given < 0) throw new IllegalStateException();
            check(true);
        }
    }
}
