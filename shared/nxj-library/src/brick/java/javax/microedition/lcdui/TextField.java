package javax.microedition.lcdui;

/** A text in a Form that somebody can change: ENTER shows a keyboard. */
public class TextField extends Item {
    /** Any characters. */
    public static final int ANY = 0x0001;

    /** An address of electronic mail. */
    public static final int EMAILADDR = 0x0002;

    /** A whole number. */
    public static final int NUMERIC = 0x0003;

    /** The number of a telephone. */
    public static final int PHONENUMBER = 0x0004;

    /** An address of the web. */
    public static final int URL = 0x0005;

    /** A decimal number. */
    public static final int DECIMAL = 0x0006;

    /** A secret text. */
    public static final int PASSWORD = 0x0100;

    /** A text that nobody can change. */
    public static final int UNEDITABLE = 0x0200;

    /** A text that nobody must keep. */
    public static final int SENSITIVE = 0x0300;

    /** A text that has no usual words. */
    public static final int NON_PREDICTIVE = 0x0400;

    /** A text whose words begin with a capital letter. */
    public static final int INITIAL_CAPS_WORD = 0x0500;

    /** A text whose sentences begin with a capital letter. */
    public static final int INITIAL_CAPS_SENTENCE = 0x0600;

    private String text;
    private final int maxSize;
    private final int constraints;

    /** Makes one of a label, a text, the most characters, and ANY: nothing can be entered for another kind of text. */
    public TextField(String label, String text, int maxSize, int constraints) {
        this.label = label;
        this.text = text;
        this.maxSize = maxSize;
        this.constraints = constraints;
        interactive = true;
        makeRoom(text);
    }

    /** Sets the text; the room stays that of the first one. */
    public void setText(String text) {
        this.text = text;
    }

    /** Gives the text. */
    public String getText() {
        return text;
    }

    /** Gives how many characters it may have. */
    public int getMaxSize() {
        return maxSize;
    }

    /** Gives what kind of text it is, such as TextField.ANY. */
    public int getConstraints() {
        return constraints;
    }

    /** Draws label and text. */
    public void paint(Graphics g, int x, int y, int w, int h, boolean selected) {
        paintText(g, text, x, y, h, selected);
    }
}
