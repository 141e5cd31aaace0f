package josx.platform.rcx;

/** Something with listeners: a sensor or a button. */
public interface ListenerCaller {
    /** Tells all listeners; the brick calls it, programs need not. */
    void callListeners();
}
