import lejos.util.TextMenu;

/** An index beyond the end is the last item; the rows move with the selected item. */
// press LEFT at 300
// press ENTER at 600
// press LEFT at 900
// press ENTER at 1200
// press RIGHT at 1500
// press RIGHT at 1800
// screen Which?
// screen >a
// screen  b
// screen  c
// screen  d
// screen  e
// screen  f
// screen  g
public class MenuOfManyItems {
    public static void main(String[] arguments) {
        TextMenu menu = new TextMenu(new String[] {"a", "b", "c", "d", "e", "f", "g", "h", "i"}, 1, "Which?");
        System.out.println(menu.select(20)); // expect 7
        System.out.println(menu.select()); // expect 8
        menu.select(7, 1000);
    }
}
