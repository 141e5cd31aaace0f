package javax.microedition.lcdui;

import java.util.ArrayList;

/** Items to choose from in a Form: ENTER goes into it, LEFT and RIGHT move, ENTER chooses, ESCAPE leaves it. */
public class ChoiceGroup extends Item implements Choice {
    private final ScrolledRows rows = new ScrolledRows();

    /** The kind, such as Choice.EXCLUSIVE. */
    protected int choiceType;

    /** The items. */
    protected ArrayList<ListElement> choiceItems;

    /** Makes an empty one with a label and a kind, such as Choice.EXCLUSIVE. */
    public ChoiceGroup(String label, int choiceType) {
        this(label, choiceType, new String[0], null);
        if (label != null && choiceType == Choice.POPUP) minHeight = Display.CHAR_HEIGHT;
    }

    /** Makes one of as many items as there are texts, but leJOS NXJ loses the texts: use append. */
    public ChoiceGroup(String label, int choiceType, String[] stringElements, Image[] imageElements) {
        if (choiceType == Choice.IMPLICIT) throw new IllegalArgumentException();
        this.label = label;
        this.choiceType = choiceType;
        interactive = true;
        minWidth = label == null ? Display.CHAR_WIDTH : label.length() * Display.CHAR_WIDTH;
        minHeight = label == null ? Display.CHAR_HEIGHT : 2 * Display.CHAR_HEIGHT;
        choiceItems = new ArrayList<ListElement>(stringElements.length);
        for (int i = 0; i < stringElements.length; i++) append(null, null);
    }

    /** Adds an item with a text and a picture, null for none, and gives how many there are. */
    public int append(String stringPart, Image imagePart) {
        choiceItems.add(new ListElement(stringPart, imagePart));
        int itemWidth = stringPart == null ? 0 : stringPart.length() * Display.CHAR_WIDTH;
        if (imagePart != null) itemWidth += imagePart.getWidth();
        minWidth = Math.max(minWidth, itemWidth);
        rows.last++;
        return choiceItems.size();
    }

    /** Takes away the item at a place. */
    public void delete(int elementNum) {
        rows.last--;
        choiceItems.remove(elementNum);
    }

    /** Takes away all items. */
    public void deleteAll() {
        rows.last = 0;
        choiceItems.clear();
    }

    /** Gives the picture of the item at a place. */
    public Image getImage(int elementNum) {
        return choiceItems.get(elementNum).picture;
    }

    /** Gives how many items there are; leJOS NXJ leaves the array as it is. */
    public int getSelectedFlags(boolean[] selectedArray_return) {
        return choiceItems.size();
    }

    /** Gives the place of the first chosen item, or -1. */
    public int getSelectedIndex() {
        for (int i = 0; i < choiceItems.size(); i++) {
            if (choiceItems.get(i).isSelected) return i;
        }
        return -1;
    }

    /** Gives the text of the item at a place. */
    public String getString(int elementNum) {
        return choiceItems.get(elementNum).text;
    }

    /** Puts an item at a place, before the one that is there. */
    public void insert(int elementNum, String stringPart, Image imagePart) {
        choiceItems.add(elementNum, new ListElement(stringPart, imagePart));
    }

    /** Tells whether the item at a place is chosen. */
    public boolean isSelected(int elementNum) {
        return choiceItems.get(elementNum).isSelected;
    }

    /** Puts an item in place of another; it is not chosen. */
    public void set(int elementNum, String stringPart, Image imagePart) {
        choiceItems.set(elementNum, new ListElement(stringPart, imagePart));
    }

    /** Says whether RIGHT goes from the last item to the first, and LEFT back; true to begin with. */
    public void setScrollWrap(boolean scrollWrap) {
        rows.wraps = scrollWrap;
    }

    /** Says of each item whether it is chosen. */
    public void setSelectedFlags(boolean[] selectedArray) {
        for (int i = 0; i < choiceItems.size(); i++) choiceItems.get(i).isSelected = selectedArray[i];
    }

    /** Says whether the item at a place is chosen; no other one is then, but for the kind MULTIPLE. */
    public void setSelectedIndex(int elementNum, boolean selected) {
        if (choiceType == Choice.MULTIPLE || !selected) {
            choiceItems.get(elementNum).isSelected = selected;
            return;
        }
        for (int i = 0; i < choiceItems.size(); i++) choiceItems.get(i).isSelected = i == elementNum;
    }

    /** Gives how many items there are. */
    public int size() {
        return choiceItems.size();
    }

    /** Is told that a button was pressed, such as Screen.KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (keyCode == Screen.KEY_LEFT) rows.left(choiceItems.size());
        if (keyCode == Screen.KEY_RIGHT) rows.right(choiceItems.size());
        if (keyCode == Screen.KEY_LEFT || keyCode == Screen.KEY_RIGHT) repaint();
        if (keyCode != Screen.KEY_ENTER) return;
        setSelectedIndex(rows.current, !choiceItems.get(rows.current).isSelected);
        notifyStateChanged();
    }

    /** Draws the label and as many items as there is room for. */
    protected void paint(Graphics g, int x, int y, int w, int h, boolean selected) {
        boolean isPopup = choiceType == Choice.POPUP;
        int atY = y;
        int rest = h;
        if (label != null) {
            g.drawString(label, x, y, 0, selected && isPopup);
            atY += Display.CHAR_HEIGHT;
            rest -= Display.CHAR_HEIGHT;
        }
        if (rest <= 0) return;
        rows.show(choiceItems.size(), rest / Display.CHAR_HEIGHT);
        if (isPopup) {
            int color = g.getColor();
            g.setColor(color == Graphics.BLACK ? Graphics.WHITE : Graphics.BLACK);
            g.fillRect(x, atY, w, rest);
            g.setColor(color);
        }
        for (int i = rows.first; i < choiceItems.size() && i <= rows.last && rest > 0; i++) {
            paint(g, choiceItems.get(i), x, atY, selected && i == rows.current);
            atY += Display.CHAR_HEIGHT;
            rest -= Display.CHAR_HEIGHT;
        }
    }

    private void paint(Graphics g, ListElement item, int x, int y, boolean isCurrent) {
        g.drawString(item.text, choiceType == Choice.POPUP ? x : x + 2 * Display.CHAR_WIDTH, y, 0, isCurrent);
        if (choiceType != Choice.EXCLUSIVE && choiceType != Choice.MULTIPLE) return;
        if (item.isSelected) g.fillArc(x, y, 8, 8, 0, 360);
        else g.drawArc(x, y, 8, 8, 0, 360);
    }
}
