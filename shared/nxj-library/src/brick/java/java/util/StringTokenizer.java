package java.util;

/**
 * Takes a text apart, word by word.
 *
 * <p>On a brick, a text is taken apart at commas if nothing else is said, and all characters given stand for one sign
 * together: with ", " it is taken apart where a comma is followed by a blank, but the blank stays. Two signs side by
 * side have an empty word between them. An empty text fails with StringIndexOutOfBoundsException.
 */
public class StringTokenizer implements Enumeration<Object> {
    private String text;
    private String delimiter;
    private int start;
    private int end;
    private boolean givesDelimiters;
    private boolean isDelimiterNext;

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

    /**
     * Takes a text apart where these characters stand, one after the other, which can be words themselves.
     *
     * @hidden
     */
    public StringTokenizer(String text, String delimiter, boolean givesDelimiters) {
        this(text, delimiter);
        this.givesDelimiters = givesDelimiters;
    }

    /** Gives how many words there are still to come. */
    public int countTokens() {
        int count = 0;
        int place = text.indexOf(delimiter, start);
        while (place >= 0) {
            count++;
            place = text.indexOf(delimiter, place + 1);
        }
        if (givesDelimiters && count > 0) count += isDelimiterNext ? count : count - 1;
        return count;
    }

    /** Says whether there is a further word. */
    public boolean hasMoreTokens() {
        return end >= start;
    }

    /** Gives the next word; fails with NoSuchElementException if there is none. */
    public String nextToken() {
        if (!hasMoreTokens()) throw new NoSuchElementException();
        if (isDelimiterNext) {
            isDelimiterNext = false;
            return delimiter;
        }
        String word = text.substring(start, end);
        start = end + 1;
        end = text.indexOf(delimiter, start);
        isDelimiterNext = givesDelimiters && hasMoreTokens();
        return word;
    }

    /**
     * Gives the next word, from now on taken apart where these characters stand.
     *
     * @hidden
     */
    public String nextToken(String delimiter) {
        if (!hasMoreTokens()) throw new NoSuchElementException();
        text = text.substring(start, text.length() - this.delimiter.length()) + delimiter;
        this.delimiter = delimiter;
        start = 0;
        end = text.indexOf(delimiter);
        isDelimiterNext = false;
        return nextToken();
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
