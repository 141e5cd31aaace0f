import javax.microedition.lcdui.Alert;
import javax.microedition.lcdui.Choice;
import javax.microedition.lcdui.Command;
import javax.microedition.lcdui.CommandListener;
import javax.microedition.lcdui.Display;
import javax.microedition.lcdui.Displayable;
import javax.microedition.lcdui.List;
import lejos.nxt.LCD;
import lejos.util.Delay;

/** A list, a question, and the screen behind it. */
// press RIGHT at 300
// press RIGHT at 700
// press LEFT at 1100
// press ENTER at 1500
// press RIGHT at 2300
// press ENTER at 2700
// press ESCAPE at 3300
// screen taken: two
// screen yes
// screen back
public class ListsOnTheDisplay {
    public static void main(String[] arguments) {
        final List list = new List("Which?", Choice.IMPLICIT);
        final Alert question = new Alert("Sure?", "Is it?", null, Alert.ALERT_TYPE_CONFIRMATION);
        final StringBuilder log = new StringBuilder();
        CommandListener listener = new CommandListener() {
            public void commandAction(Command c, Displayable d) {
                if (c.getCommandType() == Command.BACK) {
                    log.append("back");
                    Display.getDisplay().quit();
                } else if (d == list) {
                    log.append("taken: ").append(list.getString(list.getSelectedIndex())).append('\n');
                    Display.getDisplay().setCurrent(question);
                } else {
                    log.append(question.getConfirmation() ? "yes\n" : "no\n");
                    Display.getDisplay().setCurrent(list);
                }
            }
        };
        list.append("one", null);
        list.append("two", null);
        list.append("three", null);
        list.addCommand(new Command(7, "the end", Command.BACK, 1));
        list.setCommandListener(listener);
        question.setCommandListener(listener);
        Runtime.getRuntime().addShutdownHook(new Thread() {
            public void run() {
                LCD.clear();
                LCD.setAutoRefresh(true);
                LCD.drawString(log.toString(), 0, 0);
                LCD.refresh();
                Delay.msDelay(20);
            }
        });
        Display.getDisplay().setCurrent(list);
        Display.getDisplay().show(true);
    }
}
