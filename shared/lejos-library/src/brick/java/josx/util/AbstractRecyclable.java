package josx.util;

/** An object that can be used again, with the place where it waits for that. */
public abstract class AbstractRecyclable implements Recyclable {
    private Recyclable nextInLine;

    /** Makes one. */
    public AbstractRecyclable() {
    }

    /** Is called when the object is used anew. */
    public abstract void init();

    /** Is called when nobody needs the object for now. */
    public abstract void release();

    /** Gives the object that setNextRecyclable was told. */
    public Recyclable getNextRecyclable() {
        return nextInLine;
    }

    /** Remembers the next object that waits to be used again. */
    public void setNextRecyclable(Recyclable next) {
        nextInLine = next;
    }
}
