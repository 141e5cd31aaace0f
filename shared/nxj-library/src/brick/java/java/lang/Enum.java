package java.lang;

/** What all enums extend. */
public abstract class Enum<E extends Enum<E>> implements Comparable<E> {
    private final String name;
    private final int ordinal;

    /** The compiler calls it, programs cannot. */
    protected Enum(String name, int ordinal) {
        this.name = name;
        this.ordinal = ordinal;
    }

    /** Fails always: a brick does not know the names of an enum's constants. */
    public static <T extends Enum<T>> T valueOf(Class<T> type, String name) {
        throw new UnsupportedOperationException();
    }

    /** Gives the name of the constant, as it is in the program. */
    public final String name() {
        return name;
    }

    /** Gives the place of the constant; the first one is at place 0. */
    public final int ordinal() {
        return ordinal;
    }

    /** Gives a number below 0 if this constant comes before the other one, and above 0 if it comes after it. */
    public final int compareTo(E other) {
        return ordinal - ((Enum<?>) other).ordinal;
    }

    /** Gives the class of the enum itself, also for a constant with a class of its own. */
    @SuppressWarnings("unchecked")
    public final Class<E> getDeclaringClass() {
        Class<?> own = getClass();
        Class<?> extended = own.getSuperclass();
        return (Class<E>) (extended == (Class<?>) Enum.class ? own : extended);
    }

    /** Says whether both are the same constant. */
    public final boolean equals(Object other) {
        return this == other;
    }

    /** Gives a number that tells constants apart. */
    public final int hashCode() {
        return super.hashCode();
    }

    /** Fails always, for there is only one of each constant. */
    protected final Object clone() throws CloneNotSupportedException {
        throw new CloneNotSupportedException();
    }

    /** Gives the name of the constant. */
    public String toString() {
        return name;
    }

    /** Does nothing, and a brick never calls it. */
    protected final void finalize() {
    }
}
