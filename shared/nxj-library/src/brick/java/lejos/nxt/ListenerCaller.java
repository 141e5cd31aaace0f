package lejos.nxt;

/** Looks for changes and tells its listeners. */
public interface ListenerCaller {
    /** Tells all listeners; the brick calls it, programs need not. */
    int callListeners();
}
