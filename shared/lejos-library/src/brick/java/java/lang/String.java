package java.lang;

/** A text, which never changes once it is made. */
public final class String {
    // The virtual machine makes the texts that stand in a program and fills this field itself.
    final char[] characters;

    /** Makes a text of so many characters of an array, beginning at the given place. */
    public String(char[] source, int first, int count) {
        characters = new char[count];
        System.arraycopy(source, first, characters, 0, count);
    }

    /** Says how many characters there are. */
    public int length() {
        return characters.length;
    }

    /** Gives the character at a place; the first one is at place 0. */
    public char charAt(int place) {
        return characters[place];
    }

    /** Gives all characters as a new array. */
    public char[] toCharArray() {
        char[] copy = new char[characters.length];
        System.arraycopy(characters, 0, copy, 0, copy.length);
        return copy;
    }

    /** Gives any object as text, and null as "null". */
    public static String valueOf(Object object) {
        return object == null ? "null" : object.toString();
    }

    // Compilers begin `number + "text"` with one of these; on a brick nobody else can call them.

    static String valueOf(boolean value) {
        return value ? "true" : "false";
    }

    static String valueOf(char value) {
        return new StringBuffer().append(value).toString();
    }

    static String valueOf(int value) {
        return Integer.toString(value);
    }

    static String valueOf(long value) {
        return Integer.toString((int) value);
    }

    static String valueOf(float value) {
        return new StringBuffer().append(value).toString();
    }

    static String valueOf(double value) {
        return new StringBuffer().append(value).toString();
    }

    /** Says whether the other object is a text with the same characters. */
    public boolean equals(Object other) {
        if (this == other) return true;
        if (!(other instanceof String)) return false;
        char[] others = ((String) other).characters;
        if (others.length != characters.length) return false;
        for (int place = 0; place < others.length; place++) {
            if (others[place] != characters[place]) return false;
        }
        return true;
    }

    /** Gives the text itself. */
    public String toString() {
        return this;
    }
}
