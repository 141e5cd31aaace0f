package java.io;

/** Marks classes for other machines; a brick does nothing with it. */
public interface Serializable {
}
