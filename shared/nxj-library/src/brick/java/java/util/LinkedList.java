package java.util;

/** A list in which elements come and go quickly at both ends. */
public class LinkedList<E> extends AbstractList<E> {
    /** A link without an element, behind the last one and before the first one. */
    private final Link<E> ends = new Link<E>(null);
    private int count;

    /** Makes an empty list. */
    public LinkedList() {
        ends.next = ends;
        ends.previous = ends;
    }

    /** Makes a list of the elements of another collection. */
    public LinkedList(Collection<? extends E> others) {
        this();
        addAll(others);
    }

    /** Gives how many elements there are. */
    public int size() {
        return count;
    }

    /** Gives the element at a place. */
    public E get(int index) {
        return find(index, count - 1).element;
    }

    /** Puts an element in the place of another, which it gives. */
    public E set(int index, E element) {
        Link<E> link = find(index, count - 1);
        E old = link.element;
        link.element = element;
        return old;
    }

    /** Adds an element at the end. */
    public boolean add(E element) {
        insert(element, ends);
        return true;
    }

    /** Puts an element at a place; those from there on move up. */
    public void add(int index, E element) {
        insert(element, find(index, count));
    }

    /**
     * Puts an element before all others.
     *
     * @hidden
     */
    public void addFirst(E element) {
        insert(element, ends.next);
    }

    /**
     * Adds an element at the end.
     *
     * @hidden
     */
    public void addLast(E element) {
        insert(element, ends);
    }

    /**
     * Gives the first element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E getFirst() {
        if (count == 0) throw new NoSuchElementException();
        return ends.next.element;
    }

    /**
     * Gives the last element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E getLast() {
        if (count == 0) throw new NoSuchElementException();
        return ends.previous.element;
    }

    /**
     * Takes out the first element and gives it; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E removeFirst() {
        if (count == 0) throw new NoSuchElementException();
        return take(ends.next);
    }

    /**
     * Takes out the last element and gives it; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E removeLast() {
        if (count == 0) throw new NoSuchElementException();
        return take(ends.previous);
    }

    /** Takes out the element at a place, and gives it; those behind it move down. */
    public E remove(int index) {
        return take(find(index, count - 1));
    }

    /** Takes out the first such element, and says whether it was there. */
    public boolean remove(Object element) {
        for (Link<E> link = ends.next; link != ends; link = link.next) {
            if (isSame(element, link.element)) {
                take(link);
                return true;
            }
        }
        return false;
    }

    /**
     * Adds an element at the end.
     *
     * @hidden
     */
    public boolean offer(E element) {
        return add(element);
    }

    /**
     * Gives the first element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E element() {
        return getFirst();
    }

    /**
     * Gives the first element, or null if there is none.
     *
     * @hidden
     */
    public E peek() {
        return ends.next.element;
    }

    /**
     * Takes out the first element and gives it; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public E remove() {
        return removeFirst();
    }

    /**
     * Takes out the first element and gives it, or null if there is none.
     *
     * @hidden
     */
    public E poll() {
        return count == 0 ? null : take(ends.next);
    }

    /** Takes all elements out. */
    public void clear() {
        modCount++;
        ends.next = ends;
        ends.previous = ends;
        count = 0;
    }

    /** Gives what goes through the list in both directions, beginning at a place. */
    public ListIterator<E> listIterator(int index) {
        return new Elements(find(index, count), index);
    }

    private Link<E> find(int index, int last) {
        if (index < 0 || index > last) throw new IndexOutOfBoundsException();
        Link<E> link = ends;
        if (index < count / 2) {
            for (int place = 0; place <= index; place++) link = link.next;
        } else {
            for (int place = count; place > index; place--) link = link.previous;
        }
        return link;
    }

    private void insert(E element, Link<E> next) {
        modCount++;
        count++;
        Link<E> link = new Link<E>(element);
        link.next = next;
        link.previous = next.previous;
        link.previous.next = link;
        next.previous = link;
    }

    private E take(Link<E> link) {
        modCount++;
        count--;
        link.previous.next = link.next;
        link.next.previous = link.previous;
        return link.element;
    }

    private static class Link<E> {
        E element;
        Link<E> next;
        Link<E> previous;

        Link(E element) {
            this.element = element;
        }
    }

    private class Elements implements ListIterator<E> {
        private Link<E> next;
        private Link<E> given;
        private int index;
        private int expectedModCount = modCount;

        Elements(Link<E> next, int index) {
            this.next = next;
            this.index = index;
        }

        public boolean hasNext() {
            return index < count;
        }

        public boolean hasPrevious() {
            return index > 0;
        }

        public int nextIndex() {
            return index;
        }

        public int previousIndex() {
            return index - 1;
        }

        public E next() {
            check(hasNext());
            given = next;
            next = next.next;
            index++;
            return given.element;
        }

        public E previous() {
            check(hasPrevious());
            next = next.previous;
            given = next;
            index--;
            return given.element;
        }

        public void remove() {
            checkGiven();
            if (given == next) {
                next = next.next;
            } else {
                index--;
            }
            take(given);
            given = null;
            expectedModCount = modCount;
        }

        public void set(E element) {
            checkGiven();
            given.element = element;
        }

        public void add(E element) {
            check(true);
            insert(element, next);
            index++;
            given = null;
            expectedModCount = modCount;
        }

        private void check(boolean isThere) {
            if (expectedModCount != modCount) throw new ConcurrentModificationException();
            if (!isThere) throw new NoSuchElementException();
        }

        private void checkGiven() {
            if (given == null) throw new IllegalStateException();
            check(true);
        }
    }
}
