package josx.util;

/** An array of objects that can be used again; an ArrayRecycler makes it. */
public class RecyclableArray extends AbstractRecyclable {
    private Object[] room;
    private int length;

    RecyclableArray() {
    }

    /** Is called when the array is used anew. */
    public final void init() {
        length = 0;
    }

    /** Is called when nobody needs the array for now; it forgets its elements. */
    public final void release() {
        for (int place = 0; place < length; place++) room[place] = null;
        length = 0;
    }

    /** Gives how many elements the array has. */
    public final int getLength() {
        return length;
    }

    /** Gives the element at a place; the first one is at place 0. */
    public final Object get(int place) {
        check(place);
        return room[place];
    }

    /** Changes the element at a place. */
    public final void put(int place, Object element) {
        check(place);
        room[place] = element;
    }

    /** Whether it can become so long without more memory. */
    final boolean holds(int count) {
        return room != null && room.length >= count;
    }

    final void setLength(int count) {
        if (!holds(count)) room = new Object[count];
        length = count;
    }

    private void check(int place) {
        if (place < 0 || place >= length) throw new ArrayIndexOutOfBoundsException();
    }
}
