package java.lang;

/** A class says with it that its objects may be copied; a brick has no way to do so. */
public interface Cloneable {
}
