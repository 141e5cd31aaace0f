package java.lang;

/** True or false as an object. */
public final class Boolean implements Comparable<Boolean> {
    /** The object of true. */
    public static final Boolean TRUE = new Boolean(true);

    /** The object of false. */
    public static final Boolean FALSE = new Boolean(false);

    /** The class of the plain values, boolean.class. */
    @SuppressWarnings("unchecked")
    public static final Class<Boolean> TYPE = (Class<Boolean>) boolean[].class.getComponentType();

    private final boolean value;

    /** Makes an object of the value. */
    public Boolean(boolean value) {
        this.value = value;
    }

    /** Makes an object of true if the text is "true", in small or large letters, and otherwise of false. */
    public Boolean(String text) {
        this(parseBoolean(text));
    }

    /** Says whether the text is "true", in small or large letters. */
    public static boolean parseBoolean(String text) {
        return text != null && text.equalsIgnoreCase("true");
    }

    /** Gives false: a brick has no properties. */
    public static boolean getBoolean(String name) {
        return parseBoolean(System.getProperty(name));
    }

    /** Gives the object of the value. */
    public static Boolean valueOf(boolean value) {
        return value ? TRUE : FALSE;
    }

    /** Gives the object of true if the text is "true", in small or large letters, and otherwise that of false. */
    public static Boolean valueOf(String text) {
        return valueOf(parseBoolean(text));
    }

    /** Gives the value as text. */
    public static String toString(boolean value) {
        return value ? "true" : "false";
    }

    /** Gives the value. */
    public boolean booleanValue() {
        return value;
    }

    /** Gives a number below 0 if only the other one is true, and above 0 if only this one is. */
    public int compareTo(Boolean other) {
        return value == other.value ? 0 : value ? 1 : -1;
    }

    /** Says whether both have the same value. */
    public boolean equals(Object other) {
        return other instanceof Boolean && ((Boolean) other).value == value;
    }

    /** Gives a number that is the same for the same value. */
    public int hashCode() {
        return value ? 1231 : 1237;
    }

    /** Gives the value as text. */
    public String toString() {
        return toString(value);
    }
}
