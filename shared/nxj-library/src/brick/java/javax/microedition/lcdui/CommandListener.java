package javax.microedition.lcdui;

/** Is told of the commands of a screen. */
public interface CommandListener {
    /** A command was given: on a List an item was taken or ESCAPE pressed, in an Alert ENTER. */
    void commandAction(Command c, Displayable d);
}
