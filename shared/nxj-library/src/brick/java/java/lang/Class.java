package java.lang;

/**
 * A class as an object, such as String.class.
 *
 * <p>A brick knows no names of classes: as a text, a class is its number.
 */
public final class Class<T> {
    // The virtual machine makes the objects of this class and sets this field, which is the first one.
    private int number;

    private Class() {
    }

    /** Fails always: a brick cannot find classes by their names. */
    public static Class<?> forName(String name) throws ClassNotFoundException {
        throw new ClassNotFoundException(name);
    }

    /** Says whether the lines with assert are checked. */
    public native boolean desiredAssertionStatus();

    /** Gives the class that this one extends; null for Object, interfaces and types that are no classes. */
    public native Class<? super T> getSuperclass();

    /** Says whether the object has this class, or one that extends or implements it. */
    public native boolean isInstance(Object object);

    /** Says whether a variable of this class can hold objects of the other one. */
    public native boolean isAssignableFrom(Class<?> other);

    /** Says whether it is an interface. */
    public native boolean isInterface();

    /** Says whether it is the class of arrays. */
    public native boolean isArray();

    /** Says whether it is a type like int that is no class. */
    public native boolean isPrimitive();

    /** Gives a text such as "class 27": a brick knows only the number of the class. */
    public String toString() {
        return (isInterface() ? "interface " : "class ") + number;
    }
}
