import javax.microedition.lcdui.Choice;
import javax.microedition.lcdui.ChoiceGroup;
import javax.microedition.lcdui.Command;
import javax.microedition.lcdui.CommandListener;
import javax.microedition.lcdui.Display;
import javax.microedition.lcdui.Displayable;
import javax.microedition.lcdui.Form;
import javax.microedition.lcdui.Gauge;
import javax.microedition.lcdui.Item;
import javax.microedition.lcdui.ItemStateListener;
import javax.microedition.lcdui.StringItem;
import javax.microedition.lcdui.TextField;
import lejos.nxt.LCD;
import lejos.util.Delay;

/** A form: a value and a choice are changed, and a text gets a letter from the keyboard. */
// press RIGHT at 300
// press ENTER at 600
// press RIGHT at 900
// press RIGHT at 1200
// press ESCAPE at 1500
// press RIGHT at 1800
// press ENTER at 2100
// press RIGHT at 2400
// press ENTER at 2700
// press ESCAPE at 3000
// press RIGHT at 3300
// press ENTER at 3600
// press RIGHT at 3900
// press ENTER at 4200
// press LEFT at 4500
// press LEFT at 4800
// press ESCAPE at 5100
// press ESCAPE at 5400
// press ENTER at 5700
// press ESCAPE at 6000
// screen speed 5
// screen colour red
// screen name aw
// screen back
public class FormsOnTheDisplay {
    public static void main(String[] arguments) {
        final StringBuilder log = new StringBuilder();
        final Gauge gauge = new Gauge("Speed", true, 8, 3);
        final ChoiceGroup colours = new ChoiceGroup("Colour", Choice.POPUP);
        final TextField name = new TextField("Name: ", "a", 8, TextField.ANY);
        Form form = new Form("Robot");
        form.append(new StringItem("My ", "robot"));
        form.append(gauge);
        form.append(colours);
        form.append(name);
        colours.append("blue", null);
        colours.append("red", null);
        form.setItemStateListener(new ItemStateListener() {
            public void itemStateChanged(Item item) {
                if (item == gauge) log.append("speed ").append(gauge.getValue());
                if (item == colours) log.append("colour ").append(colours.getString(colours.getSelectedIndex()));
                if (item == name) log.append("name ").append(name.getText());
                log.append('\n');
            }
        });
        form.addCommand(new Command(1, Command.BACK, 0));
        form.setCommandListener(new CommandListener() {
            public void commandAction(Command c, Displayable d) {
                log.append("back");
                Display.getDisplay().quit();
            }
        });
        Runtime.getRuntime().addShutdownHook(new Thread() {
            public void run() {
                LCD.clear();
                LCD.drawString(log.toString(), 0, 0);
                LCD.refresh();
                Delay.msDelay(20);
            }
        });
        Display.getDisplay().setCurrent(form);
        Display.getDisplay().show(true);
    }
}
