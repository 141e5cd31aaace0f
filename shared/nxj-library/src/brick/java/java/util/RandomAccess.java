package java.util;

/** Marks lists that find each place equally fast. */
public interface RandomAccess {
}
