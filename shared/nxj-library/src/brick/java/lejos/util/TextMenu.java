package lejos.util;

import lejos.nxt.Button;
import lejos.nxt.LCD;

/** Lets somebody choose from a list: LEFT and RIGHT move, ENTER takes, ESCAPE takes nothing. */
public class TextMenu {
    private static final int QUIT = -2;
    private static final int TIMED_OUT = -3;
    private static final int PERIOD = 50;

    /** The row of the first item. */
    protected int topRow;

    /** The title above the items, or null. */
    protected String title;

    /** The items. */
    protected String[] items;

    private int first;
    private boolean isQuit;

    /** Makes one of items. */
    public TextMenu(String[] items) {
        this(items, 0, null);
    }

    /** Makes one of items that begins in a row. */
    public TextMenu(String[] items, int topRow) {
        this(items, topRow, null);
    }

    /** Makes one of items that begins in a row, with a title above it. */
    public TextMenu(String[] items, int topRow, String title) {
        if (topRow < 0 || topRow >= LCD.DISPLAY_CHAR_DEPTH || title != null && topRow == 0) {
            throw new IllegalArgumentException();
        }
        this.topRow = topRow;
        this.title = title;
        setItems(items);
    }

    /** Sets the title, for which there must be a row above the items. */
    public void setTitle(String title) {
        this.title = title;
        if (topRow == 0) topRow = 1;
    }

    /** Sets the items; null at the end are none. */
    public void setItems(String[] items) {
        this.items = items;
        first = 0;
    }

    /** Gives the items. */
    public String[] getItems() {
        return items;
    }

    /** Shows the items, waits, and gives the place of the chosen one, or -1 for ESCAPE. */
    public int select() {
        return select(0, 0);
    }

    /** Begins with the item at a place, and gives the place of the chosen one, or -1 for ESCAPE. */
    public int select(int selectedIndex) {
        return select(selectedIndex, 0);
    }

    /** Waits at most so many milliseconds; gives -3 after that, and -2 after quit. */
    public int select(int selectedIndex, int timeout) {
        int count = count();
        int selected = selectedIndex >= count || selectedIndex < 0 ? 0 : selectedIndex;
        Stopwatch watch = new Stopwatch();
        isQuit = false;
        while (true) {
            draw(selected, count);
            int pressed = 0;
            while (pressed == 0) {
                if (isQuit) return QUIT;
                if (timeout > 0 && watch.elapsed() >= timeout) return TIMED_OUT;
                pressed = Button.waitForAnyPress(PERIOD);
            }
            if ((pressed & Button.ID_ENTER) != 0) return count == 0 ? -1 : selected;
            if ((pressed & Button.ID_ESCAPE) != 0) return -1;
            if (count == 0) continue;
            if ((pressed & Button.ID_RIGHT) != 0) selected = selected + 1 < count ? selected + 1 : 0;
            if ((pressed & Button.ID_LEFT) != 0) selected = selected > 0 ? selected - 1 : count - 1;
        }
    }

    /** Lets select end, from another thread. */
    public void quit() {
        isQuit = true;
    }

    private int count() {
        int count = 0;
        while (count < items.length && items[count] != null) count++;
        return count;
    }

    private void draw(int selected, int count) {
        int rows = LCD.DISPLAY_CHAR_DEPTH - topRow;
        if (selected < first) first = selected;
        if (selected >= first + rows) first = selected - rows + 1;
        if (title != null) drawRow(title, topRow - 1);
        for (int row = 0; row < rows; row++) {
            int index = first + row;
            drawRow(index < count ? (index == selected ? ">" : " ") + items[index] : "", topRow + row);
        }
        LCD.asyncRefresh();
    }

    private static void drawRow(String text, int row) {
        LCD.clear(row);
        LCD.drawString(text, 0, row);
    }
}
