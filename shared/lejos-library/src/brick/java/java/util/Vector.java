package java.util;

/** A list of objects that grows as needed. */
public class Vector {
    /** The objects, with room behind them. */
    protected Object[] elementData;

    /** How much room is added when there is too little; 0 doubles it. */
    protected int capacityIncrement;

    /** How many objects there are. */
    protected int elementCount;

    /** Makes an empty list with room for seven objects. */
    public Vector() {
        this(7);
    }

    /** Makes an empty list with room for so many objects. */
    public Vector(int capacity) {
        this(capacity, 0);
    }

    /** Makes an empty list with room for so many objects and says how it grows. */
    public Vector(int capacity, int increment) {
        elementData = new Object[capacity < 0 ? 0 : capacity];
        capacityIncrement = increment;
    }

    /** Puts an object at the end. */
    public synchronized void addElement(Object element) {
        growTo(elementCount + 1);
        elementData[elementCount++] = element;
    }

    /** Says for how many objects there is room. */
    public int capacity() {
        return elementData.length;
    }

    /** Takes all objects out. */
    public void clear() {
        removeAllElements();
    }

    /** Gives the object at a place; the first one is at place 0. */
    public synchronized Object elementAt(int place) {
        check(place);
        return elementData[place];
    }

    /** Makes room for so many objects. */
    public synchronized void ensureCapacity(int capacity) {
        growTo(capacity);
    }

    /** Says whether both are the very same list. */
    public boolean equals(Object other) {
        return this == other;
    }

    /** Gives the place of an object, or -1 if it is not there. */
    public synchronized int indexOf(Object element) {
        return indexOf(element, 0);
    }

    /** Gives the place of an object, looked for from a place on, or -1 if it is not there. */
    public synchronized int indexOf(Object element, int first) {
        for (int place = first; place < elementCount; place++) {
            if (isSame(element, elementData[place])) return place;
        }
        return -1;
    }

    /** Puts an object at a place; those from there on move up. */
    public synchronized void insertElementAt(Object element, int place) {
        if (place < 0 || place > elementCount) throw new ArrayIndexOutOfBoundsException();
        growTo(elementCount + 1);
        for (int later = elementCount; later > place; later--) elementData[later] = elementData[later - 1];
        elementData[place] = element;
        elementCount++;
    }

    /** Says whether there are no objects. */
    public boolean isEmpty() {
        return elementCount == 0;
    }

    /** Gives the last place of an object, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element) {
        return lastIndexOf(element, elementCount - 1);
    }

    /** Gives the last place of an object up to a place, or -1 if it is not there. */
    public synchronized int lastIndexOf(Object element, int last) {
        if (last >= elementCount) throw new ArrayIndexOutOfBoundsException();
        for (int place = last; place >= 0; place--) {
            if (isSame(element, elementData[place])) return place;
        }
        return -1;
    }

    /** Takes all objects out. */
    public void removeAllElements() {
        setSize(0);
    }

    /** Takes an object out where it stands first, and says whether it was there. */
    public synchronized boolean removeElement(Object element) {
        int place = indexOf(element);
        if (place < 0) return false;
        removeElementAt(place);
        return true;
    }

    /** Takes out the object at a place; those behind it move down. */
    public synchronized void removeElementAt(int place) {
        check(place);
        elementCount--;
        for (int later = place; later < elementCount; later++) elementData[later] = elementData[later + 1];
        elementData[elementCount] = null;
    }

    /** Puts an object in the place of another. */
    public synchronized void setElementAt(Object element, int place) {
        check(place);
        elementData[place] = element;
    }

    /** Makes the list so long, with null for what is added. */
    public synchronized void setSize(int size) {
        growTo(size);
        for (int place = size; place < elementCount; place++) elementData[place] = null;
        elementCount = size;
    }

    /** Says how many objects there are. */
    public synchronized int size() {
        return elementCount;
    }

    /** Gives the objects as a new array. */
    public synchronized Object[] toArray() {
        return copy(elementCount);
    }

    /** Gives up the room behind the last object. */
    public synchronized void trimToSize() {
        if (elementCount < elementData.length) elementData = copy(elementCount);
    }

    private void growTo(int needed) {
        if (needed <= elementData.length) return;
        int larger = elementData.length + (capacityIncrement > 0 ? capacityIncrement : elementData.length);
        elementData = copy(larger < needed ? needed : larger);
    }

    private Object[] copy(int length) {
        Object[] copy = new Object[length];
        for (int place = 0; place < elementCount; place++) copy[place] = elementData[place];
        return copy;
    }

    private void check(int place) {
        if (place < 0 || place >= elementCount) throw new ArrayIndexOutOfBoundsException();
    }

    private static boolean isSame(Object wanted, Object element) {
        return wanted == null ? element == null : wanted.equals(element);
    }
}
