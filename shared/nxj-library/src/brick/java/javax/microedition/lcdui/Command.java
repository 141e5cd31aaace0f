package javax.microedition.lcdui;

/** What a listener is told of: a number, a kind and a rank. */
public class Command {
    /** A command of the screen. */
    public static final int SCREEN = 1;

    /** Goes back. */
    public static final int BACK = 2;

    /** Says no. */
    public static final int CANCEL = 3;

    /** Says yes. */
    public static final int OK = 4;

    /** Asks for help. */
    public static final int HELP = 5;

    /** Stops something. */
    public static final int STOP = 6;

    /** Ends the program. */
    public static final int EXIT = 7;

    /** A command of an item. */
    public static final int ITEM = 8;

    private final int commandId;
    private final String longLabel;
    private final int commandType;
    private final int priority;

    /** Makes one with a number, a kind such as Command.BACK, and a rank. */
    public Command(int commandId, int commandType, int priority) {
        this(commandId, null, commandType, priority);
    }

    /** Makes one with a number, a text, a kind such as Command.BACK, and a rank. */
    public Command(int commandId, String longLabel, int commandType, int priority) {
        this.commandId = commandId;
        this.longLabel = longLabel;
        this.commandType = commandType;
        this.priority = priority;
    }

    /** Gives its kind. */
    public int getCommandType() {
        return commandType;
    }

    /** Gives its number. */
    public int getCommandId() {
        return commandId;
    }

    /** Gives its text, or null. */
    public String getLongLabel() {
        return longLabel;
    }

    /** Gives its rank. */
    public int getPriority() {
        return priority;
    }
}
