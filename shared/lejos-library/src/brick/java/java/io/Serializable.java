package java.io;

/** A class says with it that its objects may be written to a file; a brick has no way to do so. */
public interface Serializable {
}
