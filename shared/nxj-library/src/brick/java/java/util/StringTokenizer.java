package java.util;

/**
 * Takes a text apart, word by word.
 *
 * <p>On a brick, a text is taken apart at commas if nothing else is said, and all characters given stand for one sign
 * together: with ", " it is taken apart where a comma is followed by a blank, but the blank stays. Two signs side by
 * side have an empty word between them. An empty text fails with StringIndexOutOfBoundsException.
 */
public class StringTokenizer implements Enumeration<Object> {
    private final String text;
    private final String delimiter;
    private int start;
    private int end;

    /** Takes a text apart at its commas. */
    public StringTokenizer(String text) {
        this(text, ",");
    }

    /** Takes a text apart where these characters stand, one after the other. */
    public StringTokenizer(String text, String delimiter) {
        if (text.length() == 0) throw new StringIndexOutOfBoundsException(-1);
        this.text = text + delimiter;
        this.delimiter = delimiter;
        end = this.text.indexOf(delimiter);
    }

    /** Gives how many words there are still to come. */
    public int countTokens() {
        int count = 0;
        int place = text.indexOf(delimiter, start);
        while (place >= 0) {
            count++;
            place = text.indexOf(delimiter, place + 1);
        }
        return count;
    }

    /** Says whether there is a further word. */
    public boolean hasMoreTokens() {
        return end >= start;
    }

    /** Gives the next word; fails with NoSuchElementException if there is none. */
    public String nextToken() {
        if (!hasMoreTokens()) throw new NoSuchElementException();
        String word = text.substring(start, end);
        start = end + 1;
        end = text.indexOf(delimiter, start);
        return word;
    }

    /** Says whether there is a further word. */
    public boolean hasMoreElements() {
        return hasMoreTokens();
    }

    /** Gives the next word, or null if there is none. */
    public Object nextElement() {
        return hasMoreTokens() ? nextToken() : null;
    }
}
