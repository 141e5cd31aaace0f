package java.lang;

/** What every object is: all classes extend it. */
public class Object {
    /** Makes an object. */
    public Object() {
    }

    /** Gives the class of the object. */
    public final native Class<?> getClass();

    /** Says whether both are the very same object, unless its class knows better. */
    public boolean equals(Object other) {
        return this == other;
    }

    /** Gives a number that tells objects apart. */
    public int hashCode() {
        return System.getDataAddress(this);
    }

    /** Gives the word Object with a number that tells objects apart, unless its class knows better. */
    public String toString() {
        return "Object@" + Integer.toHexString(System.identityHashCode(this));
    }

    /** Gives a copy whose fields are those of the object; its class must implement Cloneable. */
    protected Object clone() throws CloneNotSupportedException {
        if (!(this instanceof Cloneable)) throw new CloneNotSupportedException();
        return cloneObject(this);
    }

    /** Waits until another thread calls notify or notifyAll of this object. */
    public final native void wait() throws InterruptedException;

    /** Waits until another thread calls notify or notifyAll, at most for so many milliseconds; 0 are for ever. */
    public final native void wait(long milliseconds) throws InterruptedException;

    /** Waits like that; nanoseconds above 0 count as a further millisecond. */
    public final void wait(long milliseconds, int nanoseconds) throws InterruptedException {
        if (nanoseconds < 0 || nanoseconds > 999999) throw new IllegalArgumentException();
        wait(nanoseconds > 0 ? milliseconds + 1 : milliseconds);
    }

    /** Does nothing, and a brick never calls it. */
    protected void finalize() throws Throwable {
    }

    /** Wakes one of the threads that wait for this object. */
    public final native void notify();

    /** Wakes all threads that wait for this object. */
    public final native void notifyAll();

    private static native Object cloneObject(Object original);
}
