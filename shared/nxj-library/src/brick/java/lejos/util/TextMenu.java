package lejos.util;

import lejos.nxt.Button;
import lejos.nxt.LCD;

/**
 * Lets somebody choose from a list: LEFT and RIGHT move, ENTER takes, ESCAPE takes nothing.
 *
 * <p>It draws its title and its items, and leaves all other rows of the display as they are.
 */
public class TextMenu {
    /** A row without anything. */
    public static final String BLANK = "                ";

    /** What stands before the chosen item. */
    protected static final char SEL_CHAR = '>';

    /** The milliseconds for which it waits for a button before it looks whether it is to quit. */
    protected static final int BUTTON_POLL_INTERVAL = 10;

    private static final int QUIT = -2;
    private static final int TIMED_OUT = -3;

    /** The row of the first item. */
    protected int _topRow;

    /** How many items are shown. */
    protected int _height;

    /** The title above the items, or null. */
    protected String _title;

    /** The items. */
    protected String[] _items;

    /** How many items there are. */
    protected int _length;

    /** The place of the item in the first row. */
    protected int _topIndex;

    /** Whether select is to end. */
    protected boolean _quit;

    /** When select began to wait. */
    protected int _startTime;

    /** Makes one of items that begins in row 1. */
    public TextMenu(String[] items) {
        this(items, 0, null);
    }

    /** Makes one of items that begins in a row; 0 means row 1, too, because it keeps room for a title. */
    public TextMenu(String[] items, int topRow) {
        this(items, topRow, null);
    }

    /** Makes one of items that begins in a row, with a title above it. */
    public TextMenu(String[] items, int topRow, String title) {
        if (topRow < 0 || topRow == 0 && title != null) throw new IllegalArgumentException("illegal topRow argument");
        _topRow = topRow;
        setTitle(title);
        setItems(items);
    }

    /** Sets the title, which stands in the row above the items. */
    public void setTitle(String title) {
        _title = title;
        if (_topRow == 0) _topRow = 1;
        setHeight();
    }

    /** Sets the items; null is behind the last one. */
    public void setItems(String[] items) {
        _items = items;
        _length = 0;
        while (items != null && _length < items.length && items[_length] != null) _length++;
        setHeight();
    }

    /** Gives the items. */
    public String[] getItems() {
        return _items;
    }

    /** Shows the items, waits, and gives the place of the chosen one, or -1 for ESCAPE. */
    public int select() {
        return select(0, 0);
    }

    /** Begins with the item at a place, and gives the place of the chosen one, or -1 for ESCAPE. */
    public int select(int selectedIndex) {
        return select(selectedIndex, 0);
    }

    /** Waits at most so many milliseconds, 0 for ever; gives -3 after that, and -2 after quit. */
    public int select(int selectedIndex, int timeout) {
        int selected = Math.max(0, Math.min(selectedIndex, _length - 1));
        _topIndex = Math.min(Math.min(_topIndex, selected), _length - _height);
        _quit = false;
        resetTimeout();
        while (true) {
            display(selected, _topIndex);
            int pressed = 0;
            while (pressed == 0) {
                if (_quit) return QUIT;
                if (timeout > 0 && System.currentTimeMillis() - _startTime >= timeout) return TIMED_OUT;
                pressed = Button.waitForAnyPress(BUTTON_POLL_INTERVAL);
            }
            if (pressed == Button.ID_ENTER && selected >= 0 && selected < _length) return selected;
            if (pressed == Button.ID_ESCAPE) return -1;
            if (pressed == Button.ID_RIGHT) selected = next(selected);
            if (pressed == Button.ID_LEFT) selected = previous(selected);
        }
    }

    /** Lets the time of select begin again. */
    public void resetTimeout() {
        _startTime = (int) System.currentTimeMillis();
    }

    /** Lets select end, from another thread. */
    public void quit() {
        _quit = true;
    }

    /** Draws the title and the items from a place on; one of them is the chosen one. */
    protected void display(int selectedIndex, int topIndex) {
        if (_title != null) LCD.drawString(_title, 0, _topRow - 1);
        for (int row = 0; row < _height; row++) {
            LCD.drawString(BLANK, 0, _topRow + row);
            int index = topIndex + row;
            if (index >= 0 && index < _length) {
                LCD.drawChar(index == selectedIndex ? SEL_CHAR : ' ', 0, _topRow + row);
                LCD.drawString(_items[index], 1, _topRow + row);
            }
        }
        LCD.asyncRefresh();
    }

    private void setHeight() {
        _height = Math.min(LCD.DISPLAY_CHAR_DEPTH - _topRow, _length);
    }

    /** The item after the selected one, or the first one; the rows move so that it can be seen. */
    private int next(int selected) {
        if (selected + 1 >= _length) {
            _topIndex = 0;
            return 0;
        }
        if (selected + 1 >= _topIndex + _height) _topIndex = selected + 2 - _height;
        return selected + 1;
    }

    /** The item before the selected one, or the last one; the rows move so that it can be seen. */
    private int previous(int selected) {
        if (selected <= 0) {
            _topIndex = _length - _height;
            return _length - 1;
        }
        if (selected - 1 < _topIndex) _topIndex = selected - 1;
        return selected - 1;
    }
}
