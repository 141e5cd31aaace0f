package java.lang;

/** Stands for nothing, where a class has to be named. */
public final class Void {
    /** The class of no value, void.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Void> TYPE = (Class<Void>) Class.plain(12);

    private Void() {
    }
}
