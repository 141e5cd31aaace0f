import lejos.nxt.LCD;
import lejos.util.TextMenu;

// press RIGHT at 300
// press RIGHT at 600
// press LEFT at 900
// press ENTER at 1200
// press ESCAPE at 1500
// screen
// screen Choose
// screen >one
// screen  two
// screen  three
public class MenuOfTexts {
    public static void main(String[] arguments) throws InterruptedException {
        TextMenu menu = new TextMenu(new String[] {"one", "two", "three"}, 2, "Choose");
        System.out.println(menu.select()); // expect 1
        LCD.clear();
        System.out.println(menu.select(2)); // expect -1
        LCD.clear();
        System.out.println(menu.select(0, 200)); // expect -3
        LCD.clear(0);
        LCD.clear(5);
        LCD.clear(6);
        Thread.sleep(300);
        try {
            new TextMenu(new String[0], 0, "Title");
        } catch (IllegalArgumentException wrong) {
            LCD.refresh();
        }
    }
}
