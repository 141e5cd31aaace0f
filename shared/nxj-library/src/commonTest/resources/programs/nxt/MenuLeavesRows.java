import lejos.nxt.LCD;
import lejos.util.TextMenu;

/** A menu without a row begins in row 1, and draws nothing beside its items. */
// press RIGHT at 300
// screen above
// screen  left
// screen >right
// screen
// screen below
public class MenuLeavesRows {
    public static void main(String[] arguments) {
        LCD.drawString("above", 0, 0);
        LCD.drawString("below", 0, 4);
        TextMenu menu = new TextMenu(new String[] {"left", "right"});
        menu.select(0, 1000);
    }
}
