package javax.microedition.lcdui;

import java.util.ArrayList;

/** What the Display can show: a title, a ticker, and commands that go to a listener. */
public class Displayable {
    /** The button LEFT. */
    public static final int KEY_LEFT = 37;

    /** The button ENTER. */
    public static final int KEY_ENTER = 38;

    /** The button RIGHT. */
    public static final int KEY_RIGHT = 39;

    /** The button ESCAPE. */
    public static final int KEY_BACK = 40;

    /** The commands. */
    protected ArrayList<Command> commands = new ArrayList<Command>();

    /** Who is told of commands, or null. */
    protected CommandListener cmdListener;

    /** The text that moves through the first row, or null. */
    protected Ticker ticker;

    /** The title, or null. */
    protected String title;

    /** How many dots it is high; 0 until sizeChanged is called. */
    protected int height;

    /** How many dots it is wide; 0 until sizeChanged is called. */
    protected int width;

    /** Whether it is shown; leJOS NXJ never sets it. */
    protected boolean shown;

    private boolean isToBePainted;

    /** Makes one without title and commands. */
    public Displayable() {
    }

    /** Gives how many dots it is high; 0 until sizeChanged is called. */
    public int getHeight() {
        return height;
    }

    /** Gives how many dots it is wide; 0 until sizeChanged is called. */
    public int getWidth() {
        return width;
    }

    /** Sets the text that moves through the first row, null for none. */
    public void setTicker(Ticker ticker) {
        this.ticker = ticker;
    }

    /** Does nothing. */
    public void setTicker(int ticker) {
    }

    /** Gives the text that moves through the first row, or null. */
    public Ticker getTicker() {
        return ticker;
    }

    /** Sets the title, null for none. */
    public void setTitle(String s) {
        title = s;
    }

    /** Gives the title, or null. */
    public String getTitle() {
        return title;
    }

    /** Tells whether it is shown; false in leJOS NXJ. */
    public boolean isShown() {
        return shown;
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
    public void setCommandListener(CommandListener l) {
        cmdListener = l;
    }

    /** Tells the listener of each command. */
    protected void callCommandListener() {
        for (int i = 0; i < commands.size() && cmdListener != null; i++) {
            cmdListener.commandAction(commands.get(i), this);
        }
    }

    /** Is told how many dots it is wide and high. */
    protected void sizeChanged(int w, int h) {
        width = w;
        height = h;
    }

    /** Tells whether it is to be painted anew. */
    public boolean getPaintRequest() {
        return isToBePainted;
    }

    /** Says that it has been painted. */
    public void clearPaintRequest() {
        isToBePainted = false;
    }

    /** Says that it is to be painted anew. */
    public void repaint() {
        isToBePainted = true;
    }
}
