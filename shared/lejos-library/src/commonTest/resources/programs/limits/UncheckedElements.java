import josx.platform.rcx.LCD;

/** A brick does not look at what is stored in an array. */
public class UncheckedElements {
    static void store(Object[] objects, Object element) {
        try {
            objects[0] = element;
            LCD.showNumber(1); // brick shows: 1 1 1 // forgiving shows: 1 1
        } catch (ClassCastException onlyOnAComputer) {
            LCD.showNumber(2); // forgiving shows: 2
        } catch (ArrayIndexOutOfBoundsException checked) {
            LCD.showNumber(3); // shows: 3
        }
    }

    public static void main(String[] arguments) {
        store(new Object[1], new Integer(4));
        store(new String[1], "four");
        store(new String[1], new Integer(4));
        store(new String[0], new Integer(4));
        Object[] texts = new String[1];
        try {
            texts[0] = new Integer(4);
            LCD.showNumber(5); // brick shows: 5
        } catch (ClassCastException onlyOnAComputer) {
            LCD.showNumber(6); // forgiving shows: 6
        }
    }
}
