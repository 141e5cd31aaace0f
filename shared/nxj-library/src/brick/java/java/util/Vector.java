package java.util;

/** A list that grows as needed; several threads can use it at a time. */
public class Vector<E> extends AbstractList<E> implements RandomAccess {
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
        if (capacity < 0) throw new IllegalArgumentException();
        elementData = new Object[capacity];
        capacityIncrement = increment;
    }

    /** Makes a list of the elements of another collection. */
    public Vector(Collection<? extends E> others) {
        this(others.size());
        addAll(others);
    }

    /** Gives how many elements there are. */
    public synchronized int size() {
        return elementCount;
    }

    /** Gives for how many elements there is room. */
    public synchronized int capacity() {
        return elementData.length;
    }

    /** Gives the element at a place. */
    @SuppressWarnings("unchecked")
    public synchronized E get(int index) {
        check(index, elementCount - 1);
        return (E) elementData[index];
    }

    /** Puts an element in the place of another, which it gives. */
    public synchronized E set(int index, E element) {
        E old = get(index);
        elementData[index] = element;
        return old;
    }

    /** Adds an element at the end. */
    public synchronized boolean add(E element) {
        add(elementCount, element);
        return true;
    }

    /** Puts an element at a place; those from there on move up. */
    public synchronized void add(int index, E element) {
        check(index, elementCount);
        modCount++;
        ensureCapacity(elementCount + 1);
        System.arraycopy(elementData, index, elementData, index + 1, elementCount - index);
        elementData[index] = element;
        elementCount++;
    }

    /** Takes out the element at a place, and gives it; those behind it move down. */
    public synchronized E remove(int index) {
        E old = get(index);
        modCount++;
        elementCount--;
        System.arraycopy(elementData, index + 1, elementData, index, elementCount - index);
        elementData[elementCount] = null;
        return old;
    }

    /** Takes out the first such element, and says whether it was there. */
    public synchronized boolean remove(Object element) {
        int index = indexOf(element);
        if (index >= 0) remove(index);
        return index >= 0;
    }

    /** Takes all elements out. */
    public synchronized void clear() {
        setSize(0);
    }

    /** Says whether the element is there. */
    public synchronized boolean contains(Object element) {
        return indexOf(element) >= 0;
    }

    /** Gives the first place of an element, or -1 if it is not there. */
    public synchronized int indexOf(Object element) {
        return indexOf(element, 0);
    }

    /** Gives the first place of an element, looked for from a place on, or -1 if it is not there. */
    public synchronized int indexOf(Object element, int first) {
        for (int index = first; index < elementCount; index++) {
            if (isSame(element, elementData[index])) return index;
        }
        return -1;
    }

    /** Gives the last place of an element, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element) {
        return lastIndexOf(element, elementCount - 1);
    }

    /** Gives the last place of an element up to a place, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element, int last) {
        if (last >= elementCount) throw new IndexOutOfBoundsException();
        for (int index = last; index >= 0; index--) {
            if (isSame(element, elementData[index])) return index;
        }
        return -1;
    }

    /** Adds an element at the end. */
    public synchronized void addElement(E element) {
        add(elementCount, element);
    }

    /** Gives the element at a place. */
    public synchronized E elementAt(int index) {
        return get(index);
    }

    /** Gives the first element; fails with NoSuchElementException if there is none. */
    public synchronized E firstElement() {
        if (elementCount == 0) throw new NoSuchElementException();
        return get(0);
    }

    /** Gives the last element; fails with NoSuchElementException if there is none. */
    public synchronized E lastElement() {
        if (elementCount == 0) throw new NoSuchElementException();
        return get(elementCount - 1);
    }

    /** Puts an element in the place of another. */
    public synchronized void setElementAt(E element, int index) {
        set(index, element);
    }

    /** Puts an element at a place; those from there on move up. */
    public synchronized void insertElementAt(E element, int index) {
        add(index, element);
    }

    /** Takes out the first such element, and says whether it was there. */
    public synchronized boolean removeElement(Object element) {
        return remove(element);
    }

    /** Takes out the element at a place; those behind it move down. */
    public synchronized void removeElementAt(int index) {
        remove(index);
    }

    /** Takes all elements out. */
    public synchronized void removeAllElements() {
        setSize(0);
    }

    /** Gives the elements one by one. */
    public Enumeration<E> elements() {
        return new Enumeration<E>() {
            private int next;

            public boolean hasMoreElements() {
                return next < size();
            }

            public E nextElement() {
                if (next >= size()) throw new NoSuchElementException();
                return get(next++);
            }
        };
    }

    /** Copies the elements into an array. */
    public synchronized void copyInto(Object[] array) {
        System.arraycopy(elementData, 0, array, 0, elementCount);
    }

    /** Makes room for so many elements. */
    public synchronized void ensureCapacity(int capacity) {
        if (capacity <= elementData.length) return;
        int larger = elementData.length + (capacityIncrement > 0 ? capacityIncrement : elementData.length);
        resize(larger < capacity ? capacity : larger);
    }

    /** Makes the list so long, with null for what is added. */
    public synchronized void setSize(int size) {
        modCount++;
        ensureCapacity(size);
        for (int index = size; index < elementCount; index++) elementData[index] = null;
        elementCount = size;
    }

    /** Gives up the room behind the last element. */
    public synchronized void trimToSize() {
        if (elementCount < elementData.length) resize(elementCount);
    }

    private void resize(int capacity) {
        Object[] copy = new Object[capacity];
        System.arraycopy(elementData, 0, copy, 0, elementCount);
        elementData = copy;
    }

    private static void check(int index, int last) {
        if (index < 0 || index > last) throw new ArrayIndexOutOfBoundsException(index);
    }
}
