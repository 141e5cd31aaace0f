package javax.microedition.lcdui;

/** A text that moves from right to left through the first row of a screen. */
public class Ticker {
    private String str;

    /** Makes one of a text. */
    public Ticker(String str) {
        this.str = str;
    }

    /** Gives the text. */
    public String getString() {
        return str;
    }

    /** Sets the text. */
    public void setString(String str) {
        this.str = str;
    }
}
