package java.lang;

/** What every object is: all classes extend it. */
public class Object {
    /** Makes an object. */
    public Object() {
    }

    /** Says whether both are the very same object, unless its class knows better. */
    public boolean equals(Object other) {
        return this == other;
    }

    /** Gives a number that tells objects apart: where it is in the brick's memory. */
    public int hashCode() {
        return getDataAddress(this);
    }

    /** Gives the object as text, which is empty unless its class knows better. */
    public String toString() {
        return "";
    }

    /** Gives null: a brick's objects do not know their class. */
    public final Class getClass() {
        return null;
    }

    /** Lets this thread stand still until another calls notify; both have to be synchronized on this object. */
    public final native void wait() throws InterruptedException;

    /** Lets this thread stand still until another calls notify, but at most for so many milliseconds. */
    public final native void wait(long milliseconds) throws InterruptedException;

    /** Wakes one thread that waits for this object. */
    public final native void notify();

    /** Wakes all threads that wait for this object. */
    public final native void notifyAll();

    private static native int getDataAddress(Object object);
}
