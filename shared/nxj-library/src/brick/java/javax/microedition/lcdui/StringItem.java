package javax.microedition.lcdui;

/** A text with a label in a Form. */
public class StringItem extends Item {
    private String text;

    /** Makes one of a label and a text. */
    public StringItem(String label, String text) {
        this.label = label;
        this.text = text;
        makeRoom(text);
    }

    /** Gives the text. */
    public String getText() {
        return text;
    }

    /** Sets the text; the room stays that of the first one. */
    public void setText(String text) {
        this.text = text;
    }

    /** Draws label and text. */
    public void paint(Graphics g, int x, int y, int w, int h, boolean selected) {
        paintText(g, text, x, y, h, selected);
    }
}
