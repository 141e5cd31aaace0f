package java.lang;

/** Marks a class whose objects can be copied with clone. */
public interface Cloneable {
}
