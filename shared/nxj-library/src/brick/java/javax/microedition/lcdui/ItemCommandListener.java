package javax.microedition.lcdui;

/** Is told of the commands of an item of a Form. */
public interface ItemCommandListener {
    /** A command of an item was given. */
    void commandAction(Command c, Item d);
}
