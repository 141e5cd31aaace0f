package javax.microedition.lcdui;

import java.util.ArrayList;

/**
 * A list of items that fills the display: LEFT and RIGHT move, ENTER takes, and ESCAPE gives the commands.
 *
 * <p>For a list of the kind IMPLICIT, the listener is told at once; getSelectedIndex says what was taken.
 */
public class List extends Screen implements Choice {
    private final Command selection = new Command(0, Command.SCREEN, 0);
    private final ScrolledRows rows = new ScrolledRows();

    /** The kind, such as Choice.IMPLICIT. */
    protected int listType;

    /** The items. */
    protected ArrayList<ListElement> listItems;

    /** Makes an empty one with a title and a kind, such as Choice.IMPLICIT. */
    public List(String title, int listType) {
        this(title, listType, new String[0], null);
    }

    /** Makes one of texts and as many pictures, which the display does not show. */
    public List(String title, int listType, String[] stringElements, Image[] imageElements) {
        if (listType == Choice.POPUP) throw new IllegalArgumentException();
        this.title = title;
        this.listType = listType;
        listItems = new ArrayList<ListElement>(stringElements.length);
        for (int i = 0; i < stringElements.length; i++) append(stringElements[i], imageElements[i]);
    }

    /** Adds an item with a text and a picture, null for none, and gives how many there are. */
    public int append(String stringPart, Image imagePart) {
        listItems.add(new ListElement(stringPart, imagePart));
        rows.last++;
        return listItems.size();
    }

    /** Takes away the item at a place. */
    public void delete(int elementNum) {
        rows.last--;
        listItems.remove(elementNum);
    }

    /** Takes away all items. */
    public void deleteAll() {
        rows.last = 0;
        listItems.clear();
    }

    /** Gives the picture of the item at a place. */
    public Image getImage(int elementNum) {
        return listItems.get(elementNum).picture;
    }

    /** Gives how many items there are; leJOS NXJ leaves the array as it is. */
    public int getSelectedFlags(boolean[] selectedArray_return) {
        return listItems.size();
    }

    /** Gives the place of the first chosen item, or -1. */
    public int getSelectedIndex() {
        for (int i = 0; i < listItems.size(); i++) {
            if (listItems.get(i).isSelected) return i;
        }
        return -1;
    }

    /** Gives the text of the item at a place. */
    public String getString(int elementNum) {
        return listItems.get(elementNum).text;
    }

    /** Puts an item at a place, before the one that is there. */
    public void insert(int elementNum, String stringPart, Image imagePart) {
        listItems.add(elementNum, new ListElement(stringPart, imagePart));
    }

    /** Tells whether the item at a place is chosen. */
    public boolean isSelected(int elementNum) {
        return listItems.get(elementNum).isSelected;
    }

    /** Puts an item in place of another; it is not chosen. */
    public void set(int elementNum, String stringPart, Image imagePart) {
        listItems.set(elementNum, new ListElement(stringPart, imagePart));
    }

    /** Says whether RIGHT goes from the last item to the first, and LEFT back; true to begin with. */
    public void setScrollWrap(boolean scrollWrap) {
        rows.wraps = scrollWrap;
    }

    /** Says of each item whether it is chosen. */
    public void setSelectedFlags(boolean[] selectedArray) {
        for (int i = 0; i < listItems.size(); i++) listItems.get(i).isSelected = selectedArray[i];
    }

    /** Says whether the item at a place is chosen; no other one is then, but for the kind MULTIPLE. */
    public void setSelectedIndex(int elementNum, boolean selected) {
        if (listType == Choice.MULTIPLE || !selected) {
            listItems.get(elementNum).isSelected = selected;
            return;
        }
        for (int i = 0; i < listItems.size(); i++) listItems.get(i).isSelected = i == elementNum;
    }

    /** Gives how many items there are. */
    public int size() {
        return listItems.size();
    }

    /** Is told that a button was pressed, such as KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (keyCode == KEY_BACK) callCommandListener();
        if (keyCode == KEY_LEFT) rows.left(listItems.size());
        if (keyCode == KEY_RIGHT) rows.right(listItems.size());
        if (keyCode == KEY_ENTER) {
            ListElement item = listItems.get(rows.current);
            if (listType == Choice.IMPLICIT) item.isSelected = false;
            setSelectedIndex(rows.current, !item.isSelected);
            if (listType == Choice.IMPLICIT && cmdListener != null) cmdListener.commandAction(selection, this);
        }
        if (keyCode == KEY_LEFT || keyCode == KEY_RIGHT || keyCode == KEY_ENTER) repaint();
    }

    /** Draws the title and as many items as there is room for. */
    protected void paint(Graphics g) {
        int row = ticker == null ? 0 : 1;
        if (title != null) g.drawString(title, 0, row++ * Display.CHAR_HEIGHT, 0);
        rows.show(listItems.size(), Display.SCREEN_CHAR_DEPTH - row);
        for (int i = rows.first; i < listItems.size() && i <= rows.last; i++) {
            ListElement item = listItems.get(i);
            int y = row++ * Display.CHAR_HEIGHT;
            g.drawString(item.text, 2 * Display.CHAR_WIDTH, y, 0, i == rows.current);
            if (listType != Choice.EXCLUSIVE && listType != Choice.MULTIPLE) continue;
            if (item.isSelected) g.fillArc(2, y, 8, 8, 0, 360);
            else g.drawArc(2, y, 8, 8, 0, 360);
        }
    }
}
