package josx.util;

/** Gives out arrays of objects and takes them back, so that the same ones can be used again. */
public final class ArrayRecycler extends Recycler {
    private int wantedLength;

    /** Makes one that has no arrays yet. */
    public ArrayRecycler() {
    }

    /** Gives an array of this length, filled with null. */
    public RecyclableArray allocate(int length) {
        wantedLength = length;
        RecyclableArray array = (RecyclableArray) allocate();
        Recyclable tooShort = null;
        while (array.capacity() < length) {
            array.setNextRecyclable(tooShort);
            tooShort = array;
            array = (RecyclableArray) allocate();
        }
        while (tooShort != null) {
            Recyclable next = tooShort.getNextRecyclable();
            recycle(tooShort);
            tooShort = next;
        }
        array.begin(length);
        return array;
    }

    /** Makes a new array. */
    protected Recyclable createInstance() {
        return new RecyclableArray(wantedLength);
    }
}
