import josx.platform.rcx.LCD;

public class NoClassesByName {
    public static void main(String[] arguments) {
        try {
            Class.forName("NoClassesByName");
            LCD.showNumber(1);
        } catch (ClassNotFoundException never) {
            LCD.showNumber(2); // shows: 2
        }
    }
}
