package javax.microedition.lcdui;

/** Items to choose from: a List is a whole screen of them, a ChoiceGroup a part of a Form. */
public interface Choice {
    /** One item is chosen, and a circle before each shows which one. */
    int EXCLUSIVE = 1;

    /** Any number of items are chosen, and circles show which ones. */
    int MULTIPLE = 2;

    /** One item is chosen, and the listener is told at once; for a List. */
    int IMPLICIT = 3;

    /** The items show while they are asked for; for a ChoiceGroup. */
    int POPUP = 4;

    /** Long texts are cut off or not, as the display likes. */
    int TEXT_WRAP_DEFAULT = 0;

    /** Long texts go on in the next row. */
    int TEXT_WRAP_ON = 1;

    /** Long texts are cut off. */
    int TEXT_WRAP_OFF = 2;

    /** Adds an item with a text and a picture, null for none, and gives how many there are. */
    int append(String stringPart, Image imagePart);

    /** Takes away the item at a place. */
    void delete(int elementNum);

    /** Takes away all items. */
    void deleteAll();

    /** Gives the picture of the item at a place. */
    Image getImage(int elementNum);

    /** Gives how many items there are; leJOS NXJ leaves the array as it is. */
    int getSelectedFlags(boolean[] selectedArray_return);

    /** Gives the place of the first chosen item, or -1. */
    int getSelectedIndex();

    /** Gives the text of the item at a place. */
    String getString(int elementNum);

    /** Puts an item at a place, before the one that is there. */
    void insert(int elementNum, String stringPart, Image imagePart);

    /** Tells whether the item at a place is chosen. */
    boolean isSelected(int elementNum);

    /** Puts an item in place of another; it is not chosen. */
    void set(int elementNum, String stringPart, Image imagePart);

    /** Says of each item whether it is chosen. */
    void setSelectedFlags(boolean[] selectedArray);

    /** Says whether the item at a place is chosen. */
    void setSelectedIndex(int elementNum, boolean selected);

    /** Gives how many items there are. */
    int size();
}
