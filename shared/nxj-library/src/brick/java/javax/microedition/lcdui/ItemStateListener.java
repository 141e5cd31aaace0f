package javax.microedition.lcdui;

/** Is told when somebody has changed an item of a Form. */
public interface ItemStateListener {
    /** The item has changed. */
    void itemStateChanged(Item item);
}
