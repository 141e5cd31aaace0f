package java.util;

/**
 * A list that grows as needed; several threads can use it at a time.
 *
 * <p>On a brick, it is an older class that is no List: go through it with elements, or with size and elementAt. Where
 * there is room behind the last element, elementAt gives null. It is equal to no other Vector.
 */
public class Vector<E> {
    /** The elements, with room behind them. */
    protected Object[] elementData;

    /** How much room is added when there is too little; 0 doubles it. */
    protected int capacityIncrement;

    /** How many elements there are. */
    protected int elementCount;

    /** Makes an empty list. */
    public Vector() {
        this(7);
    }

    /** Makes an empty list with room for so many elements. */
    public Vector(int capacity) {
        this(capacity, 0);
    }

    /** Makes an empty list with room for so many elements, and says how it grows. */
    public Vector(int capacity, int increment) {
        if (capacity < 0) throw new IllegalArgumentException("capacity is negative");
        elementData = new Object[capacity];
        capacityIncrement = increment;
    }

    /**
     * Makes a list of the elements of another collection.
     *
     * @hidden
     */
    public Vector(Collection<? extends E> others) {
        this(others.size());
        for (E element : others) addElement(element);
    }

    /** Gives how many elements there are. */
    public synchronized int size() {
        return elementCount;
    }

    /** Says whether there are no elements. */
    public synchronized boolean isEmpty() {
        return elementCount == 0;
    }

    /** Gives for how many elements there is room. */
    public int capacity() {
        return elementData.length;
    }

    /** Gives the element at a place. */
    @SuppressWarnings("unchecked")
    public synchronized E elementAt(int index) {
        return (E) elementData[index];
    }

    /** Puts an element in the place of another. */
    public synchronized void setElementAt(E element, int index) {
        check(index, elementCount - 1);
        elementData[index] = element;
    }

    /** Adds an element at the end. */
    public synchronized void addElement(E element) {
        ensureCapacity(elementCount + 1);
        elementData[elementCount++] = element;
    }

    /** Puts an element at a place; those from there on move up. */
    public synchronized void insertElementAt(E element, int index) {
        check(index, elementCount);
        ensureCapacity(elementCount + 1);
        System.arraycopy(elementData, index, elementData, index + 1, elementCount - index);
        elementData[index] = element;
        elementCount++;
    }

    /** Takes out the first such element, and says whether it was there. */
    public synchronized boolean removeElement(E element) {
        int index = indexOf(element);
        if (index >= 0) removeElementAt(index);
        return index >= 0;
    }

    /** Takes out the element at a place; those behind it move down. */
    public synchronized void removeElementAt(int index) {
        check(index, elementCount - 1);
        System.arraycopy(elementData, index + 1, elementData, index, elementCount - index - 1);
        elementData[--elementCount] = null;
    }

    /** Takes all elements out. */
    public void removeAllElements() {
        for (int index = 0; index < elementCount; index++) elementData[index] = null;
        elementCount = 0;
    }

    /** Takes all elements out. */
    public void clear() {
        removeAllElements();
    }

    /** Gives the first place of an element, or -1 if it is not there. */
    public int indexOf(Object element) {
        return indexOf(element, 0);
    }

    /** Gives the first place of an element, looked for from a place on, or -1 if it is not there. */
    public synchronized int indexOf(Object element, int first) {
        for (int index = first; index < elementCount; index++) {
            Object other = elementData[index];
            if (element == null ? other == null : other.equals(element)) return index;
        }
        return -1;
    }

    /** Gives the last place of an element, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element) {
        return lastIndexOf(element, elementCount - 1);
    }

    /** Gives the last place of an element up to a place, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element, int last) throws ArrayIndexOutOfBoundsException {
        for (int index = last; index >= 0; index--) {
            if (AbstractCollection.isSame(element, elementData[index])) return index;
        }
        return -1;
    }

    /** Gives the elements one by one. */
    public Enumeration<E> elements() {
        return new Enumeration<E>() {
            private int next;

            public boolean hasMoreElements() {
                return next < size();
            }

            public E nextElement() {
                return elementAt(next++);
            }
        };
    }

    /** Gives an array of the elements. */
    public synchronized Object[] toArray() {
        return toArray(new Object[elementCount]);
    }

    /** Copies the elements into an array, which must have room for them, and gives it. */
    public synchronized <T> T[] toArray(T[] array) {
        if (elementCount > array.length) {
            throw new UnsupportedOperationException("Array is too small and expanding is not supported.");
        }
        System.arraycopy(elementData, 0, array, 0, elementCount);
        return array;
    }

    /** Makes room for so many elements. */
    public synchronized void ensureCapacity(int capacity) {
        if (capacity <= elementData.length) return;
        int larger = elementData.length + (capacityIncrement > 0 ? capacityIncrement : elementData.length);
        resize(larger < capacity ? capacity : larger);
    }

    /** Makes the list so long, with null for what is added. */
    public synchronized void setSize(int size) {
        ensureCapacity(size);
        for (int index = size; index < elementCount; index++) elementData[index] = null;
        elementCount = size;
    }

    /** Gives up the room behind the last element. */
    public synchronized void trimToSize() {
        if (elementCount < elementData.length) resize(elementCount);
    }

    /** Says false to any Vector, as a brick does; fails with ClassCastException for anything else but null. */
    public boolean equals(Object other) {
        if (other instanceof Vector) return false;
        return elementCount == ((Vector<?>) other).elementCount;
    }

    /** Gives the elements as text, such as [1, 2]. */
    public String toString() {
        if (elementCount < 1) return "[]";
        StringBuilder text = new StringBuilder();
        text.append('[').append(String.valueOf(elementData[0]));
        for (int index = 1; index < elementCount; index++) text.append(", ").append(String.valueOf(elementData[index]));
        return text.append(']').toString();
    }

    /**
     * Gives the element at a place.
     *
     * @hidden
     */
    public synchronized E get(int index) {
        check(index, elementCount - 1);
        return elementAt(index);
    }

    /**
     * Puts an element in the place of another, which it gives.
     *
     * @hidden
     */
    public synchronized E set(int index, E element) {
        E old = get(index);
        elementData[index] = element;
        return old;
    }

    /**
     * Adds an element at the end.
     *
     * @hidden
     */
    public synchronized boolean add(E element) {
        addElement(element);
        return true;
    }

    /**
     * Puts an element at a place; those from there on move up.
     *
     * @hidden
     */
    public synchronized void add(int index, E element) {
        insertElementAt(element, index);
    }

    /**
     * Takes out the element at a place, and gives it; those behind it move down.
     *
     * @hidden
     */
    public synchronized E remove(int index) {
        E old = get(index);
        removeElementAt(index);
        return old;
    }

    /**
     * Takes out the first such element, and says whether it was there.
     *
     * @hidden
     */
    public synchronized boolean remove(Object element) {
        int index = indexOf(element);
        if (index >= 0) removeElementAt(index);
        return index >= 0;
    }

    /**
     * Says whether the element is there.
     *
     * @hidden
     */
    public synchronized boolean contains(Object element) {
        return indexOf(element) >= 0;
    }

    /**
     * Gives the first element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public synchronized E firstElement() {
        if (elementCount == 0) throw new NoSuchElementException();
        return elementAt(0);
    }

    /**
     * Gives the last element; fails with NoSuchElementException if there is none.
     *
     * @hidden
     */
    public synchronized E lastElement() {
        if (elementCount == 0) throw new NoSuchElementException();
        return elementAt(elementCount - 1);
    }

    /**
     * Copies the elements into an array.
     *
     * @hidden
     */
    public synchronized void copyInto(Object[] array) {
        System.arraycopy(elementData, 0, array, 0, elementCount);
    }

    private void resize(int capacity) {
        Object[] copy = new Object[capacity];
        System.arraycopy(elementData, 0, copy, 0, elementCount);
        elementData = copy;
    }

    private static void check(int index, int last) {
        if (index < 0 || index > last) throw new ArrayIndexOutOfBoundsException();
    }
}
