package josx.util;

/** Gives out objects and takes them back, so that the same ones can be used again. */
public abstract class Recycler {
    private Recyclable first;

    /** Makes one that has no objects yet. */
    public Recycler() {
    }

    /** Gives an object: one that was taken back, or else a new one. */
    public final Recyclable allocate() {
        Recyclable object = first;
        if (object == null) {
            object = createInstance();
        } else {
            first = object.getNextRecyclable();
        }
        object.init();
        return object;
    }

    /** Takes an object back; nobody may use it any more. */
    public final void recycle(Recyclable object) {
        object.release();
        object.setNextRecyclable(first);
        first = object;
    }

    /** Makes a new object. */
    protected abstract Recyclable createInstance();
}
