package java.lang;

/** A class as an object, of which a brick has none. */
public final class Class {
    /** Makes an object, of which nobody has a use. */
    public Class() {
    }

    /** Fails always: a brick cannot find classes by their names. */
    public static Class forName(String name) throws ClassNotFoundException {
        throw new ClassNotFoundException(name);
    }
}
