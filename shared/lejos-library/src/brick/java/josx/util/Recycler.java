package josx.util;

/** Keeps objects that nobody needs and gives them out again, since a brick never takes back their memory. */
public abstract class Recycler {
    /** The object that was given back last; each knows the one before. */
    private Recyclable pile;

    /** Makes one that keeps nothing yet. */
    public Recycler() {
    }

    /** Gives an object: one that was recycled, or a new one if there is none. */
    public final Recyclable allocate() {
        return supply(0);
    }

    /** Takes an object back that nobody needs for now. */
    public final void recycle(Recyclable object) {
        object.release();
        synchronized (this) {
            object.setNextRecyclable(pile);
            pile = object;
        }
    }

    /** Makes a new object; write here which. */
    protected abstract Recyclable createInstance();

    /** An object of at least that size. */
    final Recyclable supply(int size) {
        Recyclable object = takeOff(size);
        if (object == null) object = createInstance();
        object.init();
        return object;
    }

    /** Whether an object that was recycled is of at least that size. */
    boolean isEnough(Recyclable object, int size) {
        return true;
    }

    /** Takes an object of at least that size off the pile; null if there is none. */
    private Recyclable takeOff(int size) {
        synchronized (this) {
            Recyclable above = null;
            Recyclable object = pile;
            while (object != null && !isEnough(object, size)) {
                above = object;
                object = object.getNextRecyclable();
            }
            if (object == null) return null;
            if (above == null) {
                pile = object.getNextRecyclable();
            } else {
                above.setNextRecyclable(object.getNextRecyclable());
            }
            object.setNextRecyclable(null);
            return object;
        }
    }
}
