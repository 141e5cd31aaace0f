package josx.util;

/** An object that can be used again, since a brick never takes back the memory of one. */
public interface Recyclable {
    /** Is called when the object is used anew. */
    void init();

    /** Is called when nobody needs the object for now. */
    void release();

    /** Gives the object that setNextRecyclable was told. */
    Recyclable getNextRecyclable();

    /** Remembers the next object that waits to be used again. */
    void setNextRecyclable(Recyclable next);
}
