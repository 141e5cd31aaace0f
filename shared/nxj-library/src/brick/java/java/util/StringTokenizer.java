package java.util;

/** Takes a text apart, word by word. */
public class StringTokenizer implements Enumeration<Object> {
    private final String text;
    private String delimiters;
    private final boolean givesDelimiters;
    private int place;

    /** Takes a text apart where it has blanks, tabs and ends of lines. */
    public StringTokenizer(String text) {
        this(text, " \t\n\r\f");
    }

    /** Takes a text apart where it has one of these characters. */
    public StringTokenizer(String text, String delimiters) {
        this(text, delimiters, false);
    }

    /** Takes a text apart where it has one of these characters, and says whether those are to be given, too. */
    public StringTokenizer(String text, String delimiters, boolean givesDelimiters) {
        if (text == null) throw new NullPointerException();
        this.text = text;
        this.delimiters = delimiters;
        this.givesDelimiters = givesDelimiters;
    }

    /** Gives how many words there are still to come. */
    public int countTokens() {
        int start = place;
        int count = 0;
        for (; hasMoreTokens(); count++) nextToken();
        place = start;
        return count;
    }

    /** Says whether there is a further word. */
    public boolean hasMoreTokens() {
        return start() < text.length();
    }

    /** Gives the next word; fails with NoSuchElementException if there is none. */
    public String nextToken() {
        if (!hasMoreTokens()) throw new NoSuchElementException();
        int start = start();
        place = start;
        while (place < text.length() && !isDelimiter(place)) place++;
        if (place == start) place++;
        return text.substring(start, place);
    }

    /** Gives the next word, which ends at one of these characters from now on. */
    public String nextToken(String delimiters) {
        this.delimiters = delimiters;
        return nextToken();
    }

    /** Says whether there is a further word. */
    public boolean hasMoreElements() {
        return hasMoreTokens();
    }

    /** Gives the next word. */
    public Object nextElement() {
        return nextToken();
    }

    /** Where the next word begins. */
    private int start() {
        int start = place;
        while (!givesDelimiters && start < text.length() && isDelimiter(start)) start++;
        return start;
    }

    private boolean isDelimiter(int place) {
        return delimiters.indexOf(text.charAt(place)) >= 0;
    }
}
