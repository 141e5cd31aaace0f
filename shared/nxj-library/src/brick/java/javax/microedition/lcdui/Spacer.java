package javax.microedition.lcdui;

/** Room between two items of a Form. */
public class Spacer extends Item {
    /** Makes one, so many dots wide and high. */
    public Spacer(int minWidth, int minHeight) {
        setMinimumSize(minWidth, minHeight);
    }

    /** Is not allowed. */
    public void addCommand(Command cmd) {
        throw new IllegalStateException();
    }

    /** Is not allowed. */
    public void setDefaultCommand(Command cmd) {
        throw new IllegalStateException();
    }

    /** Is not allowed. */
    public void setLabel(String label) {
        throw new IllegalStateException();
    }

    /** Sets how many dots it is wide and high. */
    public void setMinimumSize(int minWidth, int minHeight) {
        this.minWidth = minWidth;
        this.minHeight = minHeight;
    }

    /** Draws nothing. */
    public void paint(Graphics g, int x, int y, int w, int h, boolean selected) {
    }
}
