package josx.util;

/** Keeps arrays that nobody needs and gives them out again. */
public final class ArrayRecycler extends Recycler {
    /** Makes one that keeps nothing yet. */
    public ArrayRecycler() {
    }

    /** Gives an array of that length whose elements are all null. */
    public RecyclableArray allocate(int length) {
        RecyclableArray array = (RecyclableArray) supply(length);
        array.setLength(length);
        return array;
    }

    /** Makes a new array, which has no elements yet. */
    protected Recyclable createInstance() {
        return new RecyclableArray();
    }

    boolean isEnough(Recyclable object, int size) {
        return ((RecyclableArray) object).holds(size);
    }
}
