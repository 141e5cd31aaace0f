package javax.microedition.lcdui;

/** An item of a List or a ChoiceGroup. */
class ListElement {
    final String text;
    final Image picture;
    boolean isSelected;

    ListElement(String text, Image picture) {
        this.text = text;
        this.picture = picture;
    }
}
