package java.lang;

/** A row of characters that can be read, such as a String. */
public interface CharSequence {
    /** Gives the number of characters. */
    int length();

    /** Gives the character at a place; the first one is at place 0. */
    char charAt(int index);

    /** Gives the characters from a place up to, but not including, another. */
    CharSequence subSequence(int start, int end);

    /** Gives the characters as a String. */
    String toString();
}
