package javax.microedition.lcdui;

/** A screen that the Display shows: a List, Form, Alert or TextBox, or one of your own. */
public abstract class Screen extends Displayable {
    /** Makes one. */
    public Screen() {
    }

    /** Is told that a button was pressed, such as KEY_LEFT. */
    protected void keyPressed(int keyCode) {
    }

    /** Is for buttons that are released; the Display never calls it. */
    protected void keyReleased(int keyCode) {
    }

    /** Is told that it is shown from now on. */
    protected void showNotify() {
        repaint();
    }

    /** Is told that it is shown no more. */
    protected void hideNotify() {
        repaint();
    }

    /** Draws itself on a clear display. */
    protected abstract void paint(Graphics g);
}
