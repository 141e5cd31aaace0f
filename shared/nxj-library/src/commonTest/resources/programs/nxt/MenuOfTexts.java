import lejos.util.TextMenu;

// press RIGHT at 300
// press RIGHT at 600
// press LEFT at 900
// press ENTER at 1200
// press ESCAPE at 1500
public class MenuOfTexts {
    public static void main(String[] arguments) {
        TextMenu menu = new TextMenu(new String[] {"one", "two", "three"}, 2, "Choose");
        System.out.println(menu.select()); // expect 1
        System.out.println(menu.select(2)); // expect -1
        System.out.println(menu.select(0, 200)); // expect -3
        System.out.println(menu.getItems().length); // expect 3
        try {
            new TextMenu(new String[0], 0, "Title");
        } catch (IllegalArgumentException wrong) {
            System.out.println("no room"); // expect no room
        }
    }
}
