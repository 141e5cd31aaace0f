package javax.microedition.lcdui;

import java.util.ArrayList;

/** A part of a Form. */
public abstract class Item {
    /** The text before it, or null. */
    protected String label;

    /** How many dots it needs across. */
    protected int minWidth;

    /** How many dots it needs from top to bottom. */
    protected int minHeight;

    /** How many dots it would like to have across. */
    protected int prefWidth;

    /** How many dots it would like to have from top to bottom. */
    protected int prefHeight;

    /** Whether somebody can change it with the buttons. */
    protected boolean interactive;

    /** Who is told of its commands, or null. */
    protected ItemCommandListener cmdListener;

    /** Its commands. */
    protected ArrayList<Command> commands = new ArrayList<Command>();

    private boolean isToBePainted;

    /** Makes one. */
    public Item() {
    }

    void setLabel(String label) {
        this.label = label;
    }

    /** Gives the text before it, or null. */
    public String getLabel() {
        return label;
    }

    /** Gives how many dots it needs from top to bottom. */
    public int getMinimumHeight() {
        return minHeight;
    }

    /** Gives how many dots it needs across. */
    public int getMinimumWidth() {
        return minWidth;
    }

    /** Gives how many dots it would like to have from top to bottom. */
    public int getPreferredHeight() {
        return prefHeight;
    }

    /** Gives how many dots it would like to have across. */
    public int getPreferredWidth() {
        return prefWidth;
    }

    /** Sets how many dots it would like to have. */
    public void setPreferredSize(int width, int height) {
        prefWidth = width;
        prefHeight = height;
    }

    /** Tells whether somebody can change it with the buttons. */
    public boolean isInteractive() {
        return interactive;
    }

    /** Tells the listener of each command. */
    public void notifyStateChanged() {
        for (int i = 0; i < commands.size() && cmdListener != null; i++) {
            cmdListener.commandAction(commands.get(i), this);
        }
    }

    /** Adds a command. */
    public void addCommand(Command cmd) {
        commands.add(cmd);
    }

    /** Takes a command away that it has. */
    public void removeCommand(Command cmd) {
        commands.remove(commands.indexOf(cmd));
    }

    /** Sets who is told of commands. */
    public void setItemCommandListener(ItemCommandListener l) {
        cmdListener = l;
    }

    /** Tells whether it is to be painted anew. */
    public boolean getPaintRequest() {
        return isToBePainted;
    }

    /** Says that it is to be painted anew. */
    protected void repaint() {
        isToBePainted = true;
    }

    /** Is told that a button was pressed, such as Screen.KEY_LEFT. */
    protected void keyPressed(int keyCode) {
    }

    /** Is for buttons that are released; nothing calls it. */
    protected void keyReleased(int keyCode) {
    }

    /** Is for items that become visible; nothing calls it. */
    protected void showNotify() {
    }

    /** Is for items that become invisible; nothing calls it. */
    protected void hideNotify() {
    }

    /** Draws itself in a part of the display. */
    protected abstract void paint(Graphics g, int x, int y, int w, int h, boolean selected);

    /** Makes room for a label and a text, in one row if they fit, otherwise in two. */
    void makeRoom(String text) {
        if (label != null) {
            minWidth = label.length() * Display.CHAR_WIDTH;
            minHeight = Display.CHAR_HEIGHT;
        }
        if (text == null) return;
        int textWidth = text.length() * Display.CHAR_WIDTH;
        if (minWidth + textWidth < Display.SCREEN_WIDTH) {
            minWidth += textWidth;
        } else {
            minWidth = Math.max(minWidth, textWidth);
            minHeight += Display.CHAR_HEIGHT;
        }
    }

    /** Draws a label and a text, in one row if there is no more room, otherwise in two. */
    void paintText(Graphics g, String text, int x, int y, int h, boolean selected) {
        int textX = x;
        int textY = y;
        if (label != null) {
            g.drawString(label, x, y, 0);
            if (h <= Display.CHAR_HEIGHT) textX += label.length() * Display.CHAR_WIDTH;
            else textY += Display.CHAR_HEIGHT;
        }
        g.drawString(text, textX, textY, 0, selected);
    }
}
