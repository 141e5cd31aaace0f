package java.lang;

/**
 * A class as an object, such as String.class.
 *
 * <p>A brick knows no names of classes: as a text, a class is its number.
 */
public final class Class<T> {
    // The virtual machine makes the objects of this class and sets this field, which is the first one.
    private int number;

    /** The signs of plain values in the order of their classes' numbers. */
    private static final String PLAIN_SIGNS = "ZCFDBSIJ";
    private static final int FIRST_PLAIN = 4;

    private static Class<?>[] plain;

    private Class() {
    }

    /** Fails always: a brick cannot find classes by their names. */
    public static Class<?> forName(String name) throws ClassNotFoundException {
        throw new ClassNotFoundException(name);
    }

    /** Gives the class of plain values with a number from 4 to 12, such as 10 for int. */
    static synchronized Class<?> plain(int number) {
        if (plain == null) plain = new Class<?>[13];
        if (plain[number] == null) {
            Class<?> made = new Class<Object>();
            made.number = number;
            plain[number] = made;
        }
        return plain[number];
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

    /** Says whether it is an enum. */
    public boolean isEnum() {
        return getSuperclass() == (Class<?>) Enum.class;
    }

    /** Says false: a brick forgets annotations. */
    public boolean isAnnotation() {
        return false;
    }

    /** Gives the class of the elements of an array; null for everything else. */
    public Class<?> getComponentType() {
        Class<?> found = elementClass();
        if (found != null) return found;
        int place = PLAIN_SIGNS.indexOf(elementSign());
        return place < 0 ? null : plain(place + FIRST_PLAIN);
    }

    /** Gives the interfaces that the class names itself, in their order. */
    public Class<?>[] getInterfaces() {
        int count = 0;
        while (interfaceAt(count) != null) count++;
        Class<?>[] all = new Class<?>[count];
        for (int index = 0; index < count; index++) all[index] = interfaceAt(index);
        return all;
    }

    /** Gives this class as one that extends or implements the other one; fails with ClassCastException if it does not. */
    @SuppressWarnings("unchecked")
    public <U> Class<? extends U> asSubclass(Class<U> other) {
        if (!other.isAssignableFrom(this)) throw new ClassCastException();
        return (Class<? extends U>) this;
    }

    /** Gives the object if it has this class, or null; fails with ClassCastException if it has another one. */
    @SuppressWarnings("unchecked")
    public T cast(Object object) {
        if (object != null && !isInstance(object)) throw new ClassCastException();
        return (T) object;
    }

    private native Class<?> elementClass();

    private native char elementSign();

    private native Class<?> interfaceAt(int index);

    /** Gives a text such as "class 27": a brick knows only the number of the class. */
    public String toString() {
        return (isInterface() ? "interface " : "class ") + number;
    }
}
