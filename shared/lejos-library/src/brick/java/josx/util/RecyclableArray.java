package josx.util;

/** An array of objects that can be used again; an ArrayRecycler makes it. */
public class RecyclableArray extends AbstractRecyclable {
    private final Object[] elements;
    private int length;

    RecyclableArray(int capacity) {
        elements = new Object[capacity];
    }

    /** Is called when the array is used anew. */
    public final void init() {
    }

    /** Is called when nobody needs the array for now. */
    public final void release() {
    }

    /** Gives how many elements the array has. */
    public final int getLength() {
        return length;
    }

    /** Gives the element at a place; the first one is at place 0. */
    public final Object get(int place) {
        check(place);
        return elements[place];
    }

    /** Changes the element at a place. */
    public final void put(int place, Object element) {
        check(place);
        elements[place] = element;
    }

    final void begin(int length) {
        this.length = length;
        for (int place = 0; place < length; place++) elements[place] = null;
    }

    final int capacity() {
        return elements.length;
    }

    private void check(int place) {
        if (place < 0 || place >= length) throw new ArrayIndexOutOfBoundsException();
    }
}
