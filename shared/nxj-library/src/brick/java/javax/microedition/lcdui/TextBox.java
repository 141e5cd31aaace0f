package javax.microedition.lcdui;

import lejos.nxt.LCD;

/**
 * A keyboard on the display: LEFT and RIGHT move, ESCAPE goes to the next row, ENTER presses the key.
 *
 * <p>The key at the left of the third row changes to capital letters, the one below it to digits and signs, the one at
 * the right of the second row takes the last character back, and the one below it ends: the listener is told.
 */
public class TextBox extends Screen {
    private static final int CAPITALS = 4;
    private static final int SIGNS = 8;
    private static final int COLUMNS = 10;
    private static final int ROWS = 4;
    private static final int KEY_SIZE = 10;

    private final String[] keys = {
        "qwertyuiop", "asdfghjkl\b", "\5zxcvbnm,\r", "      -!. ",
        "QWERTYUIOP", "ASDFGHJKL\b", "\5ZXCVBNM;\r", "      -!. ",
        "()\"+*123@_", "<>'-/456#\b", "[]^|=789~\r", "      0%&$",
    };
    private final Image toSigns = new Image(8, 8, new byte[] {18, 31, 16, 0, 68, 100, 84, 72});
    private final Image toLetters = new Image(8, 8, new byte[] {28, 10, 28, 0, 112, 80, 112, 64});

    private String text;
    private int maxSize;
    private int constraints;
    private final char[] typed = new char[16];
    private int length;
    private int layer;
    private int column;
    private int row;

    /** Makes one with a title, a text, the most characters, and what kind of text it is: TextField.ANY. */
    public TextBox(String title, String text, int maxSize, int constraints) {
        this.title = title;
        this.text = text;
        this.maxSize = maxSize;
        this.constraints = constraints;
    }

    /** Sets the text, of which 16 characters can be seen. */
    public void setText(String text) {
        this.text = text;
        char[] characters = text.toCharArray();
        for (int i = 0; i < characters.length && i < typed.length; i++) typed[i] = characters[i];
        length = characters.length;
    }

    /** Gives the text as it was when the last key was pressed that ends. */
    public String getText() {
        return text;
    }

    /** Sets the most characters. */
    public void setMaxSize(int maxSize) {
        this.maxSize = maxSize;
    }

    /** Sets what kind of text it is; but for TextField.ANY, nothing can be entered. */
    public void setConstraints(int constraints) {
        this.constraints = constraints;
    }

    /** Is told that a button was pressed, such as KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (keyCode == KEY_RIGHT) column = (column + 1) % COLUMNS;
        else if (keyCode == KEY_LEFT) column = (column + COLUMNS - 1) % COLUMNS;
        else if (keyCode == KEY_BACK) row = (row + 1) % ROWS;
        else if (keyCode == KEY_ENTER) press();
        else return;
        repaint();
    }

    private void press() {
        if (column == 0 && row == 2 && layer != SIGNS) {
            layer = layer == CAPITALS ? 0 : CAPITALS;
        } else if (column == 0 && row == 3) {
            layer = layer == SIGNS ? 0 : SIGNS;
        } else if (column == COLUMNS - 1 && row == 1) {
            if (length > 0) typed[--length] = 0;
        } else if (column == COLUMNS - 1 && row == 2) {
            end();
        } else if (length < maxSize) {
            typed[length++] = keys[layer + row].charAt(column);
            if (constraints != TextField.ANY) typed[--length] = 0;
        }
    }

    /** Tells the listener of all commands, as many times as there are commands. */
    private void end() {
        text = new String(typed, 0, length);
        for (int i = 0; i < typed.length; i++) typed[i] = 0;
        length = 0;
        for (int i = 0; i < commands.size(); i++) callCommandListener();
    }

    /** Draws the title, the text and the keyboard. */
    public void paint(Graphics g) {
        if (title != null) g.drawString(title, 0, Display.CHAR_HEIGHT, 0);
        for (int i = 0; i < length && typed[i] > 0; i++) {
            g.drawChar(typed[i], i * Display.CHAR_WIDTH, 2 * Display.CHAR_HEIGHT, 0);
        }
        int top = Display.SCREEN_HEIGHT - ROWS * Display.CHAR_HEIGHT;
        g.drawRect(0, top - 1, Display.SCREEN_WIDTH - 1, ROWS * Display.CHAR_HEIGHT);
        for (int i = 1; i < ROWS; i++) {
            int y = top - 1 + i * Display.CHAR_HEIGHT;
            g.drawLine(0, y, Display.SCREEN_WIDTH, y);
        }
        for (int i = 1; i < COLUMNS; i++) g.drawLine(i * KEY_SIZE, top, i * KEY_SIZE, Display.SCREEN_WIDTH - 1);
        for (int x = 0; x < COLUMNS; x++) {
            for (int y = 0; y < ROWS; y++) {
                g.drawChar(keys[layer + y].charAt(x), x * KEY_SIZE + 2, top + y * Display.CHAR_HEIGHT, 0);
            }
        }
        g.drawImage(layer == SIGNS ? toLetters : toSigns, 1, top + 3 * Display.CHAR_HEIGHT, 0);
        g.drawRegionRop(null, 0, 0, KEY_SIZE - 1, Display.CHAR_HEIGHT - 1, column * KEY_SIZE + 1,
            top + row * Display.CHAR_HEIGHT, 0, LCD.ROP_INVERT);
    }
}
