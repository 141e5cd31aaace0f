package josx.platform.rcx;

/** How often the brick looks for changes. */
class Throttle {
    private Throttle() {
    }

    // A method of Poll's objects could not be native: a brick takes the first word for the number, which would be the object.
    static native void setThrottle(int readings);
}
