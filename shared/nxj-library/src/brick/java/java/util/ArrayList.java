package java.util;

/** A list that grows as needed and finds each place at once. */
public class ArrayList<E> extends AbstractList<E> implements RandomAccess {
    private Object[] elements;
    private int count;

    /** Makes an empty list. */
    public ArrayList() {
        this(10);
    }

    /** Makes an empty list with room for so many elements. */
    public ArrayList(int capacity) {
        if (capacity < 0) throw new IllegalArgumentException();
        elements = new Object[capacity];
    }

    /** Makes a list of the elements of another collection. */
    public ArrayList(Collection<? extends E> others) {
        this(others.size());
        addAll(others);
    }

    /** Makes a list of the elements of an array. */
    public ArrayList(E[] others) {
        this(others.length);
        addAll(others);
    }

    /** Gives how many elements there are. */
    public int size() {
        return count;
    }

    /** Gives the element at a place. */
    @SuppressWarnings("unchecked")
    public E get(int index) {
        check(index, count - 1);
        return (E) elements[index];
    }

    /** Puts an element in the place of another, which it gives. */
    public E set(int index, E element) {
        E old = get(index);
        elements[index] = element;
        return old;
    }

    /** Adds an element at the end. */
    public boolean add(E element) {
        ensureCapacity(count + 1);
        elements[count++] = element;
        return true;
    }

    /** Puts an element at a place; those from there on move up. */
    public void add(int index, E element) {
        check(index, count);
        open(index, 1);
        elements[index] = element;
    }

    /** Adds all elements of the other collection at the end, and says whether there were any. */
    public boolean addAll(Collection<? extends E> others) {
        return addAll(count, others);
    }

    /** Puts all elements of the other collection at a place, and says whether there were any. */
    public boolean addAll(int index, Collection<? extends E> others) {
        check(index, count);
        Object[] added = others.toArray();
        open(index, added.length);
        System.arraycopy(added, 0, elements, index, added.length);
        return added.length > 0;
    }

    /** Adds all elements of an array at the end, and says whether there were any. */
    public boolean addAll(E[] others) {
        return addAll(count, others);
    }

    /** Puts all elements of an array at a place, and says whether there were any. */
    public boolean addAll(int index, E[] others) {
        check(index, count);
        open(index, others.length);
        System.arraycopy(others, 0, elements, index, others.length);
        return others.length > 0;
    }

    /** Takes out the element at a place, and gives it; those behind it move down. */
    public E remove(int index) {
        E old = get(index);
        removeRange(index, index + 1);
        return old;
    }

    /** Takes out the first such element, and says whether it was there. */
    public boolean remove(Object element) {
        int index = indexOf(element);
        if (index >= 0) removeRange(index, index + 1);
        return index >= 0;
    }

    /** Takes out the elements from a place up to, but not including, another. */
    protected void removeRange(int start, int end) {
        if (start < 0 || start > end || end > count) throw new IndexOutOfBoundsException();
        modCount++;
        System.arraycopy(elements, end, elements, start, count - end);
        for (int index = count - end + start; index < count; index++) elements[index] = null;
        count -= end - start;
    }

    /** Says whether the element is there. */
    public boolean contains(Object element) {
        return indexOf(element) >= 0;
    }

    /** Gives the first place of an element, or -1 if it is not there. */
    public int indexOf(Object element) {
        for (int index = 0; index < count; index++) {
            if (isSame(element, elements[index])) return index;
        }
        return -1;
    }

    /** Gives the last place of an element, or -1 if it is not there. */
    public int lastIndexOf(Object element) {
        for (int index = count - 1; index >= 0; index--) {
            if (isSame(element, elements[index])) return index;
        }
        return -1;
    }

    /** Makes room for so many elements. */
    public void ensureCapacity(int capacity) {
        modCount++;
        if (capacity <= elements.length) return;
        int larger = elements.length * 3 / 2 + 1;
        resize(capacity > larger ? capacity : larger);
    }

    /** Gives up the room behind the last element. */
    public void trimToSize() {
        modCount++;
        if (count < elements.length) resize(count);
    }

    private void open(int index, int added) {
        ensureCapacity(count + added);
        System.arraycopy(elements, index, elements, index + added, count - index);
        count += added;
    }

    private void resize(int capacity) {
        Object[] copy = new Object[capacity];
        System.arraycopy(elements, 0, copy, 0, count);
        elements = copy;
    }

    private static void check(int index, int last) {
        if (index < 0 || index > last) throw new IndexOutOfBoundsException();
    }
}
