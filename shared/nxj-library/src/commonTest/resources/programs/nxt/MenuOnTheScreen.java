import lejos.util.TextMenu;

// press RIGHT at 300
// press RIGHT at 600
// screen
// screen Drive
// screen  slowly
// screen  quickly
// screen >not at all
public class MenuOnTheScreen {
    public static void main(String[] arguments) {
        TextMenu menu = new TextMenu(new String[] {"slowly", "quickly", "not at all", null}, 2, "Drive");
        menu.select(0, 1500);
    }
}
